#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "smt/cnf.h"

namespace solitaire {

/// Clauses, an assignment of some of their variables, and what follows from it by unit propagation. Literals
/// are those of ClauseSink.
///
/// Clauses of two and three literals, of which most formulas consist, stand in tables by literal, which are
/// made once, of those that come before the first propagation. Of the ladders among these, bounds of the two
/// numbers are compared, so that of the clauses of each only the one that says most is looked at. All other
/// clauses have two watched literals.
///
/// It keeps why each literal was assigned, from which conflict_analysis.h makes clauses to learn.
class Propagator : public ClauseSink {
 public:
  /// While nothing is decided only.
  void clause(std::span<const int> literals) override;
  void ladder(const Ladder& ladder) override;

  /// One more than the largest variable.
  std::size_t variables() const { return assigned_.size(); }
  /// -1 false, 1 true, 0 open.
  int value(int literal) const {
    const int value = values_[index(literal)];
    return value;
  }
  bool is_open(int literal) const { return value(literal) == 0; }

  /// Takes note of variables that no clause may have met.
  void reserve(int variable);
  /// Assigns an open literal as a decision, or as a consequence of those before for which there is no clause.
  void decide(int literal);
  void assign(int literal) { assign(literal, Reason{}); }
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

  static std::size_t index(int literal) {
    return literal > 0 ? 2 * static_cast<std::size_t>(literal) : 2 * static_cast<std::size_t>(-literal) + 1;
  }
  /// Entries by literal, side by side.
  template <class Entry>
  struct Table {
    std::vector<std::uint32_t> starts;  // one more than there are literals
    std::vector<Entry> entries;

    std::span<const Entry> of(std::size_t literal) const {
      if (literal + 1 >= starts.size()) return {};
      return {entries.data() + starts[literal], entries.data() + starts[literal + 1]};
    }
  };
  using Two = std::array<int, 2>;

  /// A ladder by the numbers of its chains.
  struct Step {
    int guard;
    std::uint32_t lower, upper;
    std::uint32_t first, base, count;
  };
  /// A number told by order, and how far it is known.
  struct Chain {
    std::span<const int> literals;
    std::vector<Step> as_lower, as_upper;
    std::uint32_t reached = 0;  // literals before this one hold
    std::uint32_t limit = 0;    // this one and those behind it do not hold
  };
  struct Place {
    std::uint32_t chain, position;
  };
  /// What a chain's bounds were before.
  struct Bounds {
    std::uint32_t chain, reached, limit;
  };
  struct Level {
    std::size_t trail, bounds;
  };

  void take_clauses();
  void make_tables();
  void take(std::span<const int> clause);
  void add(std::span<const int> literals);
  std::uint32_t append(std::span<const int> literals);
  void watch(std::uint32_t clause);
  void assign(int literal, Reason reason);
  std::span<const int> literals_of(std::uint32_t clause) const {
    return {&literals_[clause] + 1, static_cast<std::size_t>(literals_[clause])};
  }
  void make_ladder_tables();
  int largest_waiting() const;
  template <class Entry, class Each>
  Table<Entry> table(Each each) const;
  bool visit_tables(int falsified);
  bool visit_ladders(int assigned);
  bool raise(Place place);
  bool limit(Place place);
  bool apply_reached(const Step& ladder);
  bool apply_limit(const Step& ladder);
  bool apply(const Step& ladder, int lower, int upper);
  bool visit_clauses(int falsified);
  bool visit(Watch& watch, int falsified, bool* moved);

  std::vector<signed char> values_;  // by literal
  std::vector<Assigned> assigned_;   // by variable
  Table<int> pairs_;                 // of clauses of two, the other literal
  Table<Two> triples_;               // of clauses of three, the others
  std::vector<Ladder> ladders_;      // before there are tables
  std::vector<Chain> chains_;
  std::vector<Bounds> bounds_;  // that were changed, in this order
  Table<Place> lower_places_;   // by literal that holds: where it stands in lower chains
  Table<Place> upper_places_;   // by literal that holds: where its negation stands in upper chains
  Table<Step> guarded_;         // by literal that holds: the ladders whose guard it is
  bool has_tables_ = false;
  std::vector<std::vector<Watch>> watches_;  // by literal
  std::vector<int> literals_;                // of clauses with watches, each behind its length
  std::vector<int> waiting_;                 // clauses since the last propagation, each behind its length
  std::vector<int> trail_;
  std::vector<Level> levels_;  // where decisions stand
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
