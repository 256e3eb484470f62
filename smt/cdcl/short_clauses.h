#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "smt/cdcl/trail.h"
#include "smt/sat/literal_table.h"

namespace solitaire {

/// Clauses of two and of three literals, as most of a formula are. They stand in tables by literal, which are
/// made once.
class ShortClauses {
 public:
  ShortClauses();

  /// These add a clause, of which nothing follows until build() is called.
  void add(int a, int b) { new_pairs_.push_back({a, b}); }
  void add(int a, int b, int c) { new_triples_.push_back({a, b, c}); }
  bool has_new() const { return !new_pairs_.empty() || !new_triples_.empty(); }
  /// Makes the tables, for variables below `variables`. To be called once.
  void build(std::size_t variables);

  /// Assigns what follows since a literal is false. Returns false if a clause is broken.
  bool visit(int falsified, Trail& trail) const;

 private:
  using Two = std::array<int, 2>;
  using Three = std::array<int, 3>;

  std::vector<Two> new_pairs_;
  std::vector<Three> new_triples_;
  LiteralTable<int> pairs_;    // the other literal of each clause of two
  LiteralTable<Two> triples_;  // the other literals of each clause of three
};

}  // namespace solitaire
