#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "smt/cdcl/trail.h"
#include "smt/sat/sparse_table.h"

namespace solitaire {

/// Clauses of which two literals are watched: nothing follows from a clause before one of these is false.
class WatchedClauses {
 public:
  /// Makes room for variables below `variables`.
  void reserve(std::size_t variables) { watches_.resize(2 * variables); }
  /// Adds a clause of two literals or more, none of which is false but of a learned one, whose first is open
  /// and whose second was assigned last. Both return where it starts, for operator[].
  std::uint32_t add(std::span<const int> clause);
  std::uint32_t learn(std::span<const int> clause);
  std::size_t learned() const { return learned_.size(); }
  /// Forgets the older half of the learned clauses. Only while nothing is decided.
  void forget_half();
  std::span<const int> operator[](std::uint32_t clause) const {
    return {&literals_[clause] + 1, static_cast<std::size_t>(literals_[clause])};
  }

  /// Goes through the clauses that watch a literal which became false. Each of them finds another literal to
  /// watch, or has its last literal assigned. Returns false if one of them is broken.
  bool visit(int falsified, Trail& trail);

 private:
  struct Watch {
    std::uint32_t clause;  // where it starts in literals_
    int blocker;           // some literal of the clause; while it holds, nothing follows from the clause
  };

  void watch(int literal, Watch watch);
  bool visit(Watch& watch, int falsified, Trail& trail, bool* moved);

  SparseTable<std::vector<Watch>> watches_;  // by literal; few have any, as most clauses are short ones
  std::vector<int> literals_;                // of the clauses, each behind its length
  std::vector<std::uint32_t> learned_;       // where the learned clauses start, the oldest first
};

}  // namespace solitaire
