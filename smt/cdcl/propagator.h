#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "smt/cdcl/bounds/order_bounds.h"
#include "smt/cdcl/short_clauses.h"
#include "smt/cdcl/trail.h"
#include "smt/cdcl/watched_clauses.h"
#include "smt/sat/cnf.h"

namespace solitaire {

/// Takes clauses and conditions on ints in order encoding, which are no clauses here, and assigns what
/// follows from the decisions by unit propagation.
///
/// For each assigned literal the reason is kept, from which ConflictAnalysis makes clauses to learn.
class Propagator : public ClauseSink {
 public:
  /// Takes a clause. Only while nothing is decided.
  void clause(std::span<const int> literals) override;
  /// These take conditions of which there are no clauses here. Those that come after the first propagation
  /// are written as clauses.
  void order_implication(const OrderImplication& order_implication) override;
  void order_difference(const OrderDifference& difference) override;
  bool takes_linear_implications() const override { return !is_built_; }
  void linear_implication(const LinearImplication& implication) override { bounds_.add(implication); }
  /// Returns for how many clauses the conditions stand that are none here, sums left out.
  std::uint64_t spared_clauses() const { return spared_clauses_; }

  /// Makes room for variables up to this one, which may stand in no clause.
  void reserve(int variable);
  /// decide() assigns an open literal as a decision. assign() does so as a consequence of the decisions
  /// before it, where no clause says so.
  void decide(int literal);
  void assign(int literal) { trail_.assign(literal); }
  /// Assigns all that follows. Returns false if a clause is broken. If nothing was decided then, it returns
  /// false for good.
  bool propagate();
  /// Takes back the last decision with all that followed, and returns it.
  int undo();

  // What is assigned, and why: see Trail.
  std::size_t variables() const { return trail_.variables(); }
  int value(int literal) const { return trail_.value(literal); }
  bool is_open(int literal) const { return trail_.is_open(literal); }
  std::size_t decisions() const { return trail_.decisions(); }
  std::size_t level(int variable) const { return trail_.level(variable); }
  std::span<const int> trail(std::size_t decisions = 0) const { return trail_.literals(decisions); }
  std::size_t take_kept() { return trail_.take_kept(); }
  /// Returns the broken clause. For use after propagate() returned false.
  std::span<const int> conflict() const { return trail_.conflict(); }
  /// Calls `visit` with each of the false literals from which an assigned one followed.
  template <class Visit>
  void for_each_reason(int assigned, Visit visit) const;

  /// Adds a clause that follows from the others, and assigns its first literal, which has to be open. All
  /// others have to be false, and none assigned later than the second one.
  void learn(std::span<const int> clause);
  std::size_t learned() const { return watched_.learned(); }
  /// Forgets the older half of the learned clauses. Only while nothing is decided.
  void forget_half() { watched_.forget_half(); }

 private:
  void take_clauses();
  void build();
  void take(std::span<const int> clause);
  void add(std::span<const int> literals);

  Trail trail_;
  ShortClauses short_;        // those that came before the first propagation
  OrderBounds bounds_;        // conditions on ints in order encoding
  WatchedClauses watched_;    // all other clauses
  std::vector<int> waiting_;  // clauses to watch that came since the last propagation, each behind its length
  int largest_ = 0;           // the largest variable in any clause
  std::uint64_t spared_clauses_ = 0;
  bool is_built_ = false;  // the tables of short_ and bounds_
  bool is_broken_ = false;
};

template <class Visit>
void Propagator::for_each_reason(int assigned, Visit visit) const {
  const Reason& reason = trail_.reason(assigned);
  const auto visit_others = [&](const auto& clause) {
    for (const int literal : clause) {
      if (literal != assigned) visit(literal);
    }
  };
  if (reason.clause == Reason::kOthers) {
    if (reason.first != 0) visit(reason.first);
    if (reason.second != 0) visit(reason.second);
  } else if (reason.clause == Reason::kDifference) {
    visit_others(bounds_.clause_of_difference(static_cast<std::uint32_t>(reason.first),
                                              static_cast<std::uint32_t>(reason.second)));
  } else if (reason.clause == Reason::kSum) {
    const std::uint32_t place = trail_.place(assigned);
    const auto is_known = [&](int literal) { return value(literal) > 0 && trail_.place(literal) < place; };
    bounds_.explain_by_sum(static_cast<std::uint32_t>(reason.first),
                           static_cast<std::uint32_t>(reason.second), is_known, visit);
  } else {
    visit_others(watched_[reason.clause]);
  }
}

}  // namespace solitaire
