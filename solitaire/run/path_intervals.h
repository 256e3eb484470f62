#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tracegraph/graph.h"
#include "tracegraph/seen_parts.h"

namespace solitaire {

/// Keeps what the conditions on the current path say about single ints: narrower intervals than the graph's
/// own, which hold for all executions. They decide the branch that ends a recursion of chosen length, without
/// a solver: after n == 0, n == 1, n == 2 were all false, an n of 0..3 is 3. What is computed of such ints is
/// narrowed with them, so that a recursion on n - 1 or on n % m ends as well.
///
/// Kept as a stack: what a side of a branch assumes is dropped where the branch joins.
class PathIntervals {
 public:
  explicit PathIntervals(const Graph* graph) : graph_(graph) {}

  /// From here on the condition is true, or false.
  void assume(NodeId condition, bool holds);
  /// Returns whether the condition holds, where the facts settle it.
  std::optional<bool> decide(NodeId condition) const;
  /// Narrows an int that was just computed, by what is known of its operands.
  void derive(NodeId made);

  std::size_t size() const { return known_.size(); }
  void drop_from(std::size_t size);
  /// Hides all facts so far, for what must not depend on them; returns what show_from() puts back.
  std::size_t hide() { return std::exchange(first_, known_.size()); }
  void show_from(std::size_t first) { first_ = first; }

 private:
  struct Fact {
    NodeId node;
    Interval interval;
    std::size_t before;  // the number of the node's last fact before this one, or kNone
  };
  static constexpr std::size_t kNone = SIZE_MAX;
  /// A comparison of an int with a constant.
  struct Comparison {
    NodeId node;
    Op op;
    bool constant_left;
    std::int64_t constant;
  };
  std::optional<Comparison> comparison(NodeId condition) const;
  Interval own_interval(NodeId node) const;
  Interval interval(NodeId node) const;
  std::size_t last_fact(NodeId node) const;
  void narrow(NodeId node, Interval interval);
  /// The same of a condition that is no conjunction.
  void assume_single(NodeId condition, bool holds);

  const Graph* graph_;  // null where no condition is ever assumed
  std::vector<Fact> known_;
  std::unordered_map<NodeId, std::size_t> last_;  // the number of each node's last fact
  std::size_t first_ = 0;
  SeenParts seen_;  // by assume(); empty between calls
};

}  // namespace solitaire
