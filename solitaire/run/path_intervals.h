#pragma once
#include <optional>
#include <utility>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// Keeps what the conditions on the current path say about single ints: narrower intervals than the graph's
/// own, which hold for all executions. They decide the branch that ends a recursion of chosen length, without
/// a solver: after n == 0, n == 1, n == 2 were all false, an n of 0..3 is 3.
///
/// Kept as a stack: what a side of a branch assumes is dropped where the branch joins.
class PathIntervals {
 public:
  explicit PathIntervals(const Graph* graph) : graph_(graph) {}

  /// From here on the condition is true, or false.
  void assume(NodeId condition, bool holds);
  /// Returns whether the condition holds, where the facts settle it.
  std::optional<bool> decide(NodeId condition) const;

  std::size_t size() const { return known_.size(); }
  void drop_from(std::size_t size) { known_.resize(size); }
  /// Hides all facts so far, for what must not depend on them; returns what show_from() puts back.
  std::size_t hide() { return std::exchange(first_, known_.size()); }
  void show_from(std::size_t first) { first_ = first; }

 private:
  struct Fact {
    NodeId node;
    Interval interval;
  };
  /// A comparison of an int with a constant.
  struct Comparison {
    NodeId node;
    Op op;
    bool constant_left;
    std::int64_t constant;
  };
  std::optional<Comparison> comparison(NodeId condition) const;
  Interval interval(NodeId node) const;
  void narrow(NodeId node, Interval interval);

  const Graph* graph_;  // null where no condition is ever assumed
  std::vector<Fact> known_;
  std::size_t first_ = 0;
};

}  // namespace solitaire
