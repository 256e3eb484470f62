#pragma once
#include <span>

#include "tracegraph/graph.h"

namespace solitaire {

/// Distribution::log_density as nodes: the logarithm of the density of `value`, within the distribution's
/// support, where parameters depend on choices. Outside of the support it is some other number or undefined.
///
/// `parameters` are those of the family in their order, as floats: one or two as of Distribution, or the
/// weights; of a range, or of an index without weights, its lo, hi and step as ints. Throws as Graph::apply.
NodeId log_density(Graph& graph, const Distribution& distribution, std::span<const NodeId> parameters,
                   NodeId value);

/// Distribution::contains as a node, for values of the right type.
NodeId in_support(Graph& graph, const Distribution& distribution, std::span<const NodeId> parameters,
                  NodeId value);

}  // namespace solitaire
