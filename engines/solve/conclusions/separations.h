#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// A node, or its negation.
struct SignedNode {
  NodeId node;
  bool holds = true;
};

/// The least and the greatest value of an int, and the conditions that say so, if the interval does not.
struct IntBounds {
  Interval values;
  std::optional<SignedNode> low, high;
};

/// Two places along one axis, and how long the thing at each is: the other one does not begin before its end.
struct AxisSeparation {
  std::array<NodeId, 2> at;
  std::array<std::int64_t, 2> length;
};

/// A condition that keeps two things apart, along one axis or along either of two.
struct Separation {
  SignedNode condition;
  std::array<AxisSeparation, 2> axes;
  std::size_t number = 0;  // of axes
};

/// What conditions say about things that must not overlap, and about where ints lie.
struct Separations {
  std::vector<Separation> pairs;
  std::vector<SignedNode> comparisons;  // of ints, by <, <= and ==
  std::unordered_map<NodeId, IntBounds>
      bounds;  // of ints for which a condition says more than their interval

  /// Returns the bounds of an int, by its interval and by conditions.
  IntBounds bounds_of(const Graph& graph, NodeId node) const {
    const auto known = bounds.find(node);
    return known != bounds.end() ? known->second : IntBounds{graph.node(node).interval, {}, {}};
  }
};

/// Takes conditions apart into conjuncts, and finds those that keep two things apart or bound an int. A
/// condition that keeps things apart says that two ints differ, or is a disjunction of comparisons by which
/// one thing ends before the other begins, either way round, along one axis or two.
Separations find_separations(const Graph& graph, const std::vector<NodeId>& conditions);
/// Adds what further conditions say.
void add_separations(const Graph& graph, const std::vector<NodeId>& conditions, Separations& found);

}  // namespace solitaire
