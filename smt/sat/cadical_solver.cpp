#include "smt/sat/cadical_solver.h"

#include <optional>
#include <vector>

#include "smt/sat/cadical.h"
#include "smt/sat/graph_clauses.h"

namespace solitaire {
namespace {

class CadicalSolver : public Solver {
 public:
  CadicalSolver(const Graph& graph, std::uint64_t seed)
      : graph_(graph), cadical_(Cadical::Use::kProof, seed), clauses_(graph, cadical_) {}

  void add_clause(std::span<const NodeId> conditions) override { clauses_.add_clause(conditions); }

  Verdict check(std::span<const NodeId> assumptions, const StopSignal& signal) override {
    const std::vector<int> assumed = clauses_.assume(assumptions);
    const Verdict verdict = cadical_.solve(assumed, signal, conflicts_);
    if (verdict == Verdict::kSatisfiable)
      model_ = clauses_.values([this](int variable) { return cadical_.holds(variable); });
    if (verdict == Verdict::kUnsatisfiable) core_ = cadical_.core(assumptions, assumed);
    return verdict;
  }

  void limit_effort(std::uint64_t conflicts) override { conflicts_ = conflicts; }
  bool suggest(std::size_t, std::int64_t) override { return false; }

  std::int64_t value(std::size_t variable) override {
    const auto value = variable < model_.size() ? model_[variable] : std::nullopt;
    return value.value_or(graph_.variables()[variable].domain.lo);  // nothing depends on it
  }

  std::vector<NodeId> core() override { return core_; }

 private:
  const Graph& graph_;
  Cadical cadical_;
  GraphClauses clauses_;
  std::vector<std::optional<std::int64_t>> model_;
  std::vector<NodeId> core_;
  std::uint64_t conflicts_ = 0;
};

}  // namespace

std::unique_ptr<Solver> make_cadical_solver(const Graph& graph, std::uint64_t seed) {
  return std::make_unique<CadicalSolver>(graph, seed);
}

}  // namespace solitaire
