#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/stop_signal.h"
#include "smt/sat/cnf.h"
#include "smt/solver.h"
#include "tracegraph/graph.h"

namespace CaDiCaL {
class Solver;
}

namespace solitaire {

/// The SAT solver CaDiCaL (Biere, Fazekas, Fleury and Heisinger 2020), set up for this project. The solver is
/// made, and gets its clauses, when it is first asked, because both take longer than many a search that does
/// without it.
class Cadical : public ClauseSink {
 public:
  enum class Use : std::uint8_t {
    kProof,       // a single answer, which may be that there is no model
    kRefutation,  // answers that are mostly that there is no model
    kDiversity,   // many models, one after the other, that are far from each other
  };

  explicit Cadical(Use use = Use::kProof, std::uint64_t seed = 0);
  ~Cadical() override;

  void clause(std::span<const int> literals) override;
  void order_implication(const OrderImplication& order_implication) override;
  void order_difference(const OrderDifference& difference) override;

  /// Makes searches try these literals first, until prefer_nothing().
  void prefer(std::vector<int> literals);
  void prefer_nothing();

  /// Decides whether the clauses have a model under the assumptions. Returns kStopped if the signal or the
  /// limit of conflicts of this call came first. With 0 conflicts there is no such limit.
  Verdict solve(std::span<const int> assumptions, const StopSignal& signal, std::uint64_t conflicts = 0);
  /// Goes on with a new solver that has the same clauses and nothing of what this one learned or came to
  /// last. It tries `phase` first of each variable. Not for use between solve() and what asks for its result.
  void start_anew(std::uint64_t seed, bool phase = true);
  /// Begins anew for another use, if it is another one.
  void use_for(Use use);
  /// Returns the value of a variable in the model. For use after kSatisfiable.
  bool holds(int variable) const;
  /// Returns those of the conditions that the proof needed; `assumed` has the literal by which each was
  /// assumed, at the same place. For use after kUnsatisfiable.
  std::vector<NodeId> core(std::span<const NodeId> conditions, std::span<const int> assumed);

 private:
  void set_up();
  void tell();

  Use use_;
  std::uint64_t seed_;
  bool phase_ = true;
  std::unique_ptr<CaDiCaL::Solver> solver_;
  std::vector<int> untold_;  // the clauses that CaDiCaL does not know yet, each ended by 0
  std::vector<OrderImplication> untold_implications_;
  std::vector<OrderDifference> untold_differences_;
  std::vector<int> preferred_;
};

}  // namespace solitaire
