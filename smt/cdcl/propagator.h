#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "smt/sat/cnf.h"
#include "smt/sat/literal_table.h"
#include "smt/sat/order_bounds.h"
#include "smt/sat/sparse_table.h"

namespace solitaire {

/// Clauses, an assignment of some of their variables, and what follows from it by unit propagation. Literals
/// are those of ClauseSink.
///
/// Clauses of two and three literals, of which most formulas consist, stand in tables by literal, which are
/// made once, of those that come before the first propagation; so do ladders (order_bounds.h). All others
/// have two watched literals.
///
/// It keeps why each literal was assigned, from which conflict_analysis.h makes clauses to learn.
class Propagator : public ClauseSink {
 public:
  Propagator();

  /// While nothing is decided only.
  void clause(std::span<const int> literals) override;
  void order_implication(const OrderImplication& order_implication) override;

  /// One more than the largest variable.
  std::size_t variables() const { return assigned_.size(); }
  /// -1 false, 1 true, 0 open.
  int value(int literal) const {
    return static_cast<int>(values_[static_cast<std::size_t>(middle_ + literal)]);
  }
  bool is_open(int literal) const { return value(literal) == 0; }

  /// Takes note of variables that no clause may have met.
  void reserve(int variable);
  /// Assigns an open literal as a decision, or as a consequence of those before for which there is no clause.
  void decide(int literal);
  void assign(int literal) { assign(literal, kNoClause); }
  /// Assigns all that follows; false if a clause is broken, and for good if that is without decisions.
  bool propagate();
  std::size_t decisions() const { return levels_.size(); }
  /// Takes the last decision back, with all that followed; returns it.
  int undo();

  /// What is assigned, in this order, since so many decisions were made.
  std::span<const int> trail(std::size_t decisions = 0) const {
    return std::span(trail_).subspan(decisions == 0 ? 0 : levels_[decisions - 1].trail);
  }
  /// How many decisions had been made when the variable was assigned.
  std::size_t level(int variable) const { return assigned_[static_cast<std::size_t>(variable)].level; }
  /// After propagate() returned false: the clause that is broken.
  std::span<const int> conflict() const { return conflict_; }
  /// Calls with each literal, all false, from which an assigned one followed.
  template <class Visit>
  void for_each_reason(int assigned, Visit visit) const;

  /// Adds a clause that follows from the others and is false but for its first literal, which is open and is
  /// now assigned. Of the rest none may have been assigned later than the second one.
  void learn(std::span<const int> clause);
  std::size_t learned() const { return learned_.size(); }
  /// Forgets the older half of what was learned. While nothing is decided only.
  void forget_half();

 private:
  /// An enum, as what is written as a char may be anything, after which all else would be read again.
  enum class Truth : std::int8_t { kFails = -1, kOpen, kHolds };

  struct Watch {
    std::uint32_t clause;  // where it starts in literals_
    int blocker;           // a literal of the clause: if it holds, so does the clause
  };

  /// The other literals of the clause from which one followed.
  struct Reason {
    std::uint32_t clause = kNoClause;  // where it starts in literals_
    int first = 0, second = 0;         // if it stands in a table; 0: none
  };
  static constexpr std::uint32_t kNoClause = static_cast<std::uint32_t>(-1);
  struct Assigned {
    std::uint32_t level = 0;
    Reason reason;
  };

  using Two = std::array<int, 2>;
  using Three = std::array<int, 3>;
  /// Where a decision stands in the trail, and how many changes of bounds came before it.
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
  /// Because of the clause that starts there, or of one in a table, whose others these are.
  void assign(int literal, std::uint32_t clause, int first = 0, int second = 0);
  void set(int literal, Truth value) { values_[static_cast<std::size_t>(middle_ + literal)] = value; }
  std::span<const int> literals_of(std::uint32_t clause) const {
    return {&literals_[clause] + 1, static_cast<std::size_t>(literals_[clause])};
  }
  bool visit_tables(int falsified);
  bool visit_bounds(int assigned);
  bool apply(int a, int b, int c);
  bool visit_clauses(int falsified);
  bool visit(Watch& watch, int falsified, bool* moved);

  std::vector<Truth> values_{Truth::kOpen};  // by literal, from that of -middle_ to that of middle_
  int middle_ = 0;
  std::vector<Assigned> assigned_;  // by variable
  LiteralTable<int> pairs_;         // of clauses of two, the other literal
  LiteralTable<Two> triples_;       // of clauses of three, the others
  OrderBounds bounds_;              // of order_implications
  bool has_tables_ = false;
  SparseTable<std::vector<Watch>> watches_;  // by literal; few have any, as most clauses stand in tables
  std::vector<int> literals_;                // of clauses with watches, each behind its length
  std::vector<Two> new_pairs_;               // clauses for the tables, until these are made
  std::vector<Three> new_triples_;
  std::vector<int> waiting_;  // other clauses since the last propagation, each behind its length
  int largest_ = 0;           // variable of all these
  std::vector<int> trail_;
  std::vector<Level> levels_;  // of decisions
  std::size_t propagated_ = 0;
  bool broken_ = false;
  std::vector<int> conflict_;
  std::vector<std::uint32_t> learned_;  // where clauses start in literals_, in this order
};

template <class Visit>
void Propagator::for_each_reason(int assigned, Visit visit) const {
  const Reason& reason = assigned_[static_cast<std::size_t>(assigned > 0 ? assigned : -assigned)].reason;
  if (reason.clause != kNoClause) {
    for (const int literal : literals_of(reason.clause)) {
      if (literal != assigned) visit(literal);
    }
  } else {
    if (reason.first != 0) visit(reason.first);
    if (reason.second != 0) visit(reason.second);
  }
}

}  // namespace solitaire
