#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "base/grouped_table.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Returns what an operation comes to for operands of which some may have no value; nothing where that has no
/// meaning. Of an ite only the side that is taken counts, and one operand may decide a connective by itself.
std::optional<Scalar> folded(Op op, std::span<const std::optional<Scalar>> operands);

/// Evaluates nodes under given values of the choices: the specification that solvers' models are held
/// against. The graph may grow meanwhile.
class Assignment {
 public:
  /// `value_of` gives each choice variable (by its number in graph.variables()) its value.
  Assignment(const Graph& graph, std::function<Scalar(std::size_t)> value_of);

  /// The node's value; nothing where it depends on an operation without meaning, such as a division by zero.
  std::optional<Scalar> value(NodeId node);
  /// Returns true if a bool node is true.
  bool holds(NodeId node);

  /// Asks for the values of the choices again. Of what was evaluated, only what depends on a choice with
  /// another value than before is evaluated anew.
  void take_changes();

 private:
  enum class State : std::uint8_t { kUnknown, kKnown, kUndefined };
  /// Makes room for all nodes that the graph has by now.
  void cover_graph();
  void cover_users();
  void evaluate(NodeId node);
  void compute(NodeId node);
  void forget(NodeId node);
  State state(NodeId node) const { return states_[node.index]; }

  const Graph& graph_;
  std::function<Scalar(std::size_t)> value_of_;
  std::vector<State> states_;
  std::vector<Scalar> values_;
  GroupedTable<NodeId> users_;   // by node: those that have it as an operand; empty before values change
  std::vector<NodeId> pending_;  // while something is forgotten
};

}  // namespace solitaire
