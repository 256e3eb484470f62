#pragma once
#include <cstdint>
#include <vector>

#include "smt/cnf.h"

namespace solitaire {

/// Clauses, an assignment of some of their variables, and what follows from it by unit propagation (with two
/// watched literals). Literals are those of ClauseSink.
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
  /// Assigns all that follows; false if a clause is broken.
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
  void add(std::span<const int> literals);
  bool visit_clauses(int falsified);
  bool visit(Watch& watch, int falsified, bool* moved);

  std::vector<signed char> values_;        // by literal
  std::vector<std::vector<int>> implied_;  // by literal: of clauses of two, the others where it is false
  std::vector<std::vector<Watch>> watches_;
  std::vector<int> literals_;  // clauses of three or more, each behind its length
  std::vector<int> trail_;
  std::vector<std::size_t> levels_;  // where decisions stand in the trail
  std::size_t propagated_ = 0;
  bool broken_ = false;
};

}  // namespace solitaire
