#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "engines/solve/conclusions/separations.h"
#include "smt/z3/linear_contradiction.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// A linear row over the unknowns of LinearFacts, and the conditions from which it follows, if it is not true
/// of all ints.
struct LinearFact {
  LinearRow row;
  std::vector<SignedNode> because;
};

/// What linear facts are about: an int node, or a bool node as 0 or 1.
struct Unknown {
  NodeId node;
  Interval range;
  std::vector<SignedNode> low,
      high;  // conditions from which the ends follow, if not from the node's interval
};

/// Reads comparisons of ints as linear facts about what LinearSum takes them apart into.
class LinearFacts {
 public:
  explicit LinearFacts(const Graph& graph) : graph_(graph) {}

  /// Adds what a comparison says, unless it is none, or too large to be worth it.
  void add(SignedNode comparison);
  /// Adds what follows from facts of at most two unknowns about the ends of ranges, and from these about
  /// equations: `x == 3` fails where 3 is out of range, of several such about one x at most one holds, and
  /// exactly one if they are about all values in the range. To be called once, at the end.
  void complete();

  const std::vector<LinearFact>& facts() const { return facts_; }
  const std::vector<Unknown>& unknowns() const { return unknowns_; }

 private:
  void add(NodeId from, NodeId to, std::int64_t least, SignedNode because);
  std::size_t unknown(NodeId node, Interval range);
  bool narrow();
  bool narrow(const LinearFact& fact, const LinearTerm& term);
  void read_equations();
  void relate_equations(NodeId of, const std::vector<std::size_t>& equations);

  const Graph& graph_;
  std::vector<LinearFact> facts_;
  std::vector<Unknown> unknowns_;
  std::unordered_map<NodeId, std::size_t> numbers_;  // of the unknowns
};

}  // namespace solitaire
