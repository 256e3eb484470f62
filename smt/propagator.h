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
/// made once, of those that come before the first propagation. All others have two watched literals.
class Propagator : public ClauseSink {
 public:
  /// While nothing is decided only.
  void clause(std::span<const int> literals) override;

  /// -1 false, 1 true, 0 open.
  int value(int literal) const {
    const int value = values_[index(literal)];
    return value;
  }
  bool is_open(int literal) const { return value(literal) == 0; }

  /// Takes note of variables that no clause may have met.
  void reserve(int variable);
  /// Assigns an open literal as a decision, or as a consequence of those before.
  void decide(int literal);
  void assign(int literal);
  /// Assigns all that follows; false if a clause is broken, and for good if that is without decisions.
  bool propagate();
  std::size_t decisions() const { return levels_.size(); }
  /// Takes the last decision back, with all that followed; returns it.
  int undo();

 private:
  struct Watch {
    std::uint32_t clause;  // where it starts in literals_
    int blocker;           // a literal of the clause: if it holds, so does the clause
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

  void take_clauses();
  void make_tables();
  void take(std::span<const int> clause);
  void add(std::span<const int> literals);
  bool visit_tables(int falsified);
  bool visit_clauses(int falsified);
  bool visit(Watch& watch, int falsified, bool* moved);

  std::vector<signed char> values_;  // by literal
  Table<int> pairs_;                 // of clauses of two, the other literal
  Table<Two> triples_;               // of clauses of three, the others
  bool has_tables_ = false;
  std::vector<std::vector<Watch>> watches_;  // by literal
  std::vector<int> literals_;                // of clauses with watches, each behind its length
  std::vector<int> waiting_;                 // clauses since the last propagation, each behind its length
  std::vector<int> trail_;
  std::vector<std::size_t> levels_;  // where decisions stand in the trail
  std::size_t propagated_ = 0;
  bool broken_ = false;
};

}  // namespace solitaire
