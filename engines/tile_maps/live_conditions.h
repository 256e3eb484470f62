#pragma once
#include <array>
#include <functional>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tracegraph/assignment.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Conditions on choices whose values change a few at a time: only what depends on them is evaluated again.
class LiveConditions {
 public:
  /// `values` says what the choices are at first. The graph must outlive this, and may grow meanwhile.
  LiveConditions(const Graph& graph, std::vector<NodeId> conditions, Assignment& values);

  const std::vector<NodeId>& conditions() const { return conditions_; }
  /// Gives a choice variable another value. Nothing happens if no condition depends on it.
  void set(NodeId variable, Scalar value);
  /// Evaluates what depends on the variables that were set.
  void settle();
  /// Returns the value of a node below a condition; nothing where it has none. After settle().
  std::optional<Scalar> value(NodeId node) const { return values_[places_.at(node.index)]; }
  bool depends_on(NodeId variable) const { return places_.contains(variable.index); }
  bool holds(std::size_t condition) const { return is_true(roots_[condition]); }
  /// Returns how many conditions do not hold. After settle().
  std::size_t broken() const { return broken_; }
  /// Returns the conditions that were broken since the last call, some of which may hold again.
  std::vector<std::size_t> take_broken() { return std::exchange(newly_broken_, {}); }

 private:
  using Place = std::uint32_t;  // of a node, among those below the conditions, operands first

  bool is_true(Place place) const { return values_[place] && values_[place]->i != 0; }
  void touch_users(Place place);
  void evaluate(Place place);

  struct Part {
    Op op;
    std::array<Place, 3> operands;
  };

  std::vector<NodeId> conditions_;
  std::vector<Part> parts_;  // by place
  std::unordered_map<std::uint32_t, Place> places_;
  std::vector<std::optional<Scalar>> values_;             // by place
  std::vector<std::vector<Place>> users_;                 // by place: the nodes that it is an operand of
  std::vector<std::optional<std::size_t>> condition_of_;  // by place: of which condition it is the root
  std::vector<Place> roots_;                              // by condition
  std::vector<bool> touched_;                             // by place: it is in the queue
  std::priority_queue<Place, std::vector<Place>, std::greater<>> queue_;
  std::size_t broken_ = 0;
  std::vector<std::size_t> newly_broken_;
};

}  // namespace solitaire
