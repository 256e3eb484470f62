#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "smt/cdcl/bounds/order_bounds.h"
#include "smt/sat/cnf.h"
#include "smt/sat/literal_table.h"
#include "smt/sat/sparse_table.h"

namespace solitaire {

/// Keeps clauses and an assignment of some of their variables, and assigns what follows from it by unit
/// propagation. Literals are those of ClauseSink.
///
/// Most clauses of a formula have two or three literals. Those that come before the first propagation stand
/// in tables by literal, which are made once. Conditions on ints in order encoding are no clauses at all
/// (bounds/order_bounds.h). All other clauses have two watched literals.
///
/// For each assigned literal the propagator keeps the reason, from which ConflictAnalysis makes clauses to
/// learn.
class Propagator : public ClauseSink {
 public:
  Propagator();

  /// Takes a clause. Only while nothing is decided.
  void clause(std::span<const int> literals) override;
  /// These take conditions of which there are no clauses here. Those that come after the first propagation
  /// are written as clauses.
  void order_implication(const OrderImplication& order_implication) override;
  void order_difference(const OrderDifference& difference) override;
  bool takes_linear_implications() const override { return !has_tables_; }
  void linear_implication(const LinearImplication& implication) override { bounds_.add(implication); }
  /// Returns for how many clauses the conditions stand that are none here, sums left out.
  std::uint64_t spared_clauses() const { return spared_clauses_; }

  /// Returns one more than the largest variable.
  std::size_t variables() const { return assigned_.size(); }
  /// Returns -1 for a literal that is false, 1 for one that is true, and 0 for an open one.
  int value(int literal) const {
    return static_cast<int>(values_[static_cast<std::size_t>(middle_ + literal)]);
  }
  bool is_open(int literal) const { return value(literal) == 0; }

  /// Makes room for variables up to this one, which may stand in no clause.
  void reserve(int variable);
  /// decide() assigns an open literal as a decision. assign() does so as a consequence of the decisions
  /// before it, where no clause says so.
  void decide(int literal);
  void assign(int literal) { assign(literal, kNoClause); }
  /// Assigns all that follows. Returns false if a clause is broken. If nothing was decided then, it returns
  /// false for good.
  bool propagate();
  std::size_t decisions() const { return levels_.size(); }
  /// Takes back the last decision with all that followed, and returns it.
  int undo();

  /// Returns what was assigned after so many decisions, in the order of assignment.
  std::span<const int> trail(std::size_t decisions = 0) const {
    return std::span(trail_).subspan(decisions == 0 ? 0 : levels_[decisions - 1].trail);
  }
  /// Returns how much of the trail has stayed as it was since the last call. What was assigned behind that is
  /// new.
  std::size_t take_kept() { return std::exchange(kept_, trail_.size()); }
  /// Returns how many decisions had been made when the variable was assigned.
  std::size_t level(int variable) const { return assigned_[static_cast<std::size_t>(variable)].level; }
  /// Returns the broken clause. For use after propagate() returned false.
  std::span<const int> conflict() const { return conflict_; }
  /// Calls `visit` with each of the false literals from which an assigned one followed.
  template <class Visit>
  void for_each_reason(int assigned, Visit visit) const;

  /// Adds a clause that follows from the others, and assigns its first literal, which has to be open. All
  /// others have to be false, and none assigned later than the second one.
  void learn(std::span<const int> clause);
  std::size_t learned() const { return learned_.size(); }
  /// Forgets the older half of the learned clauses. Only while nothing is decided.
  void forget_half();

 private:
  /// This is an enum and no char, because a write through a char may change any object, so that compilers
  /// read all other members again after each.
  enum class Truth : std::int8_t { kFails = -1, kOpen, kHolds };

  friend class OrderBounds;
  friend class OrderImplications;
  friend class OrderDifferences;
  friend class LinearSums;

  struct Watch {
    std::uint32_t clause;  // where it starts in literals_
    int blocker;           // some literal of the clause; while it holds, nothing follows from the clause
  };

  /// Says from which clause a literal followed.
  struct Reason {
    std::uint32_t clause = kNoClause;  // where it starts in literals_, or one of the following
    /// Of a clause in a table: its other literals, or 0. Of a difference: its number, and the position. Of a
    /// sum: its number, and that of the term.
    int first = 0, second = 0;
  };
  static constexpr std::uint32_t kNoClause = static_cast<std::uint32_t>(-1);
  static constexpr std::uint32_t kDifference = static_cast<std::uint32_t>(-2);
  static constexpr std::uint32_t kSum = static_cast<std::uint32_t>(-3);
  struct Assigned {
    std::uint32_t level = 0;
    std::uint32_t place = 0;  // in the trail
    Reason reason;
  };

  using Two = std::array<int, 2>;
  using Three = std::array<int, 3>;
  /// The place of a decision in the trail, and the number of changes of bounds before it.
  struct Level {
    std::size_t trail, bounds;
  };

  void take_clauses();
  void make_tables();
  void take(std::span<const int> clause);
  void add(std::span<const int> literals);
  std::uint32_t append(std::span<const int> literals);
  void watch(std::uint32_t clause);
  void watch(int literal, Watch watch);
  /// Assigns a literal because of the clause that starts there, or because of one in a table, of which
  /// `first` and `second` are the other literals.
  void assign(int literal, std::uint32_t clause, int first = 0, int second = 0);
  std::uint32_t place(int literal) const {
    return assigned_[static_cast<std::size_t>(literal > 0 ? literal : -literal)].place;
  }
  void set(int literal, Truth value) { values_[static_cast<std::size_t>(middle_ + literal)] = value; }
  std::span<const int> literals_of(std::uint32_t clause) const {
    return {&literals_[clause] + 1, static_cast<std::size_t>(literals_[clause])};
  }
  bool visit_tables(int falsified);
  bool visit_bounds(int assigned) { return bounds_.visit(assigned, *this); }
  bool apply(int a, int b, int c);
  void assign_by_difference(int literal, std::uint32_t step, std::uint32_t position) {
    assign(literal, kDifference, static_cast<int>(step), static_cast<int>(position));
  }
  bool assign_by_sum(int literal, std::uint32_t sum, std::uint32_t term);
  void break_clause(std::span<const int> literals) { conflict_.assign(literals.begin(), literals.end()); }
  bool visit_clauses(int falsified);
  bool visit(Watch& watch, int falsified, bool* moved);

  std::vector<Truth> values_{Truth::kOpen};  // by literal, from that of -middle_ to that of middle_
  int middle_ = 0;
  std::vector<Assigned> assigned_;  // by variable
  LiteralTable<int> pairs_;         // the other literal of each clause of two
  LiteralTable<Two> triples_;       // the other literals of each clause of three
  std::uint64_t spared_clauses_ = 0;
  OrderBounds bounds_;  // what follows from conditions on ints in order encoding
  bool has_tables_ = false;
  SparseTable<std::vector<Watch>> watches_;  // by literal; few have any, as most clauses stand in tables
  std::vector<int> literals_;                // of clauses with watches, each behind its length
  std::vector<Two> new_pairs_;               // clauses for the tables, before these are made
  std::vector<Three> new_triples_;
  std::vector<int> waiting_;  // other clauses that came since the last propagation, each behind its length
  int largest_ = 0;           // the largest variable in any clause
  std::vector<int> trail_;
  std::size_t kept_ = 0;       // see take_kept()
  std::vector<Level> levels_;  // of decisions
  std::size_t propagated_ = 0;
  bool broken_ = false;
  std::vector<int> conflict_;
  std::vector<std::uint32_t> learned_;  // where the learned clauses start in literals_, the oldest first
};

template <class Visit>
void Propagator::for_each_reason(int assigned, Visit visit) const {
  const Assigned& at = assigned_[static_cast<std::size_t>(assigned > 0 ? assigned : -assigned)];
  const Reason& reason = at.reason;
  const auto visit_others = [&](const auto& clause) {
    for (const int literal : clause) {
      if (literal != assigned) visit(literal);
    }
  };
  if (reason.clause == kNoClause) {
    if (reason.first != 0) visit(reason.first);
    if (reason.second != 0) visit(reason.second);
  } else if (reason.clause == kDifference) {
    visit_others(bounds_.clause_of_difference(static_cast<std::uint32_t>(reason.first),
                                              static_cast<std::uint32_t>(reason.second)));
  } else if (reason.clause == kSum) {
    const auto is_known = [&](int literal) { return value(literal) > 0 && place(literal) < at.place; };
    bounds_.explain_by_sum(static_cast<std::uint32_t>(reason.first),
                           static_cast<std::uint32_t>(reason.second), is_known, visit);
  } else {
    visit_others(literals_of(reason.clause));
  }
}

}  // namespace solitaire
