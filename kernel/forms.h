#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// The shape of a density's logarithm as a function of one choice c, all others being what they are.
enum class Form : std::uint8_t {
  kUnknown,
  kNormal,   // in the span of 1, c, c^2
  kGamma,    // in the span of 1, log c, c
  kBeta,     // in the span of 1, log c, log(1 - c)
  kWeights,  // c has few values, and each has a weight
};

/// A form with the numbers that the density has in it, as nodes that do not depend on the choice: the
/// coefficients of the functions above, without that of 1; or the logarithm of the weight of each value, up
/// to what all have in common.
struct KnownForm {
  Form form = Form::kUnknown;
  std::vector<NodeId> numbers;
  /// What else has to hold where the choice changes.
  std::vector<NodeId> required = {};
};

/// What of a trace depends on a choice: nodes in ascending order, of which the choice is the first, and those
/// of them that are terms of the density, and conditions that an execution has to keep.
struct Reach {
  std::vector<std::uint32_t> nodes;
  std::vector<NodeId> terms;
  std::vector<NodeId> required;
};

/// The form along a float, if the float's own distribution has it, too, so that given all else the float has
/// a distribution of that family. `fixed_parameters` says that the parameters of its distribution depend on
/// no choice. Conditions are not looked at. Adds nodes to the graph.
std::optional<KnownForm> form_of_float(Graph& graph, NodeId choice, const Distribution& distribution,
                                       bool fixed_parameters, const Reach& reach);

/// The slope of a node along a float, if the node is a line along it: a node that does not depend on the
/// float. The reach has the node as its only term. Adds nodes to the graph.
std::optional<NodeId> slope_of_line(Graph& graph, NodeId choice, const Reach& reach);

/// The weights of the values of a choice that has few of them; of those that conditions rule out the
/// logarithm is minus infinity. Nothing where that would take many more operations than the trace has.
std::optional<KnownForm> weights_of_values(Graph& graph, NodeId choice, const Distribution& distribution,
                                           const Reach& reach);

}  // namespace solitaire
