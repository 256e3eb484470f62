#include "tracegraph/simplex.h"

namespace solitaire {
namespace {

bool is_one(const Graph& graph, NodeId id) {
  return graph.node(id).op == Op::kConstFloat && graph.scalar(id).f == 1;
}

/// The other factor of a product that has this one; nothing if it is no such product.
std::optional<NodeId> cofactor(const Graph& graph, NodeId product, NodeId factor) {
  const Graph::Node& node = graph.node(product);
  if (node.op != Op::kMulFloat) return std::nullopt;
  if (node.operands[0] == factor) return node.operands[1];
  if (node.operands[1] == factor) return node.operands[0];
  return std::nullopt;
}

bool is_complement(const Graph& graph, NodeId id, NodeId of) {
  const Graph::Node& node = graph.node(id);
  return node.op == Op::kSubFloat && is_one(graph, node.operands[0]) && node.operands[1] == of;
}

/// Whether the parts break a stick. `rest` is what was left after the part before; at first all of it, which
/// is no node.
bool breaks_stick(const Graph& graph, std::span<const NodeId> parts) {
  std::optional<NodeId> rest;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const std::optional<NodeId> share = rest ? cofactor(graph, parts[i], *rest) : parts[i];
    if (!share) return false;
    // The next part, or the last one, is made of what is left now.
    const NodeId next = parts[i + 1];
    const auto is_left = [&](NodeId left) {
      if (!rest) return is_complement(graph, left, *share);
      const auto complement = cofactor(graph, left, *rest);
      return complement && is_complement(graph, *complement, *share);
    };
    if (i + 2 == parts.size()) return is_left(next);
    const Graph::Node& product = graph.node(next);
    if (product.op != Op::kMulFloat) return false;
    if (is_left(product.operands[0])) {
      rest = product.operands[0];
    } else if (is_left(product.operands[1])) {
      rest = product.operands[1];
    } else {
      return false;
    }
  }
  return parts.size() == 1 && is_one(graph, parts[0]);
}

/// One side of a selection that all parts make by one condition.
bool selected_sums_to_one(const Graph& graph, std::span<const NodeId> parts, std::size_t side) {
  std::vector<NodeId> selected;
  const NodeId condition = graph.node(parts[0]).operands[0];
  for (const NodeId part : parts) {
    const Graph::Node& node = graph.node(part);
    if (node.op != Op::kIteFloat || node.operands[0] != condition) return false;
    selected.push_back(node.operands[side]);
  }
  return sums_to_one(graph, selected);
}

}  // namespace

bool sums_to_one(const Graph& graph, std::span<const NodeId> parts) {
  if (parts.empty()) return false;
  if (graph.node(parts[0]).op == Op::kIteFloat)
    return selected_sums_to_one(graph, parts, 1) && selected_sums_to_one(graph, parts, 2);
  return breaks_stick(graph, parts);
}

}  // namespace solitaire
