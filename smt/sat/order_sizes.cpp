#include "smt/sat/order_sizes.h"

#include <array>
#include <cstddef>
#include <vector>

#include "smt/operation_rows.h"
#include "smt/sat/wide_choices.h"

namespace solitaire {

/// Returns the size of a node with that interval. A leaf is given as its own operand.
using OrderSizing = OrderSize (*)(const OrderSizes&, Interval result, const NodeId* operands);

struct OrderSizingRow {
  Op op;
  OrderSizing size;
};

/// Of the operations that have an order encoding.
struct OrderSizings {
  using S = const OrderSizes&;
  using N = const NodeId*;
  using I = Interval;

  // clang-format off
  static constexpr OrderSizingRow kRows[] = {
      {Op::kConstInt, [](S, I, N) { return OrderSize{1, 0}; }},
      {Op::kChoice, [](S s, I, N a) { return s.choices_.order_size(s.graph_.node(*a).payload); }},
      {Op::kAdd, [](S s, I i, N a) { return sum_size(i, s.of(a[0]), s.of(a[1])); }},
      {Op::kSub, [](S s, I i, N a) { return sum_size(i, s.of(a[0]), s.of(a[1])); }},
      {Op::kMul, [](S s, I i, N a) { return product_size(i, s.sized(a[0]), s.sized(a[1])); }},
      {Op::kDiv, [](S s, I i, N a) { return quotient_size(i, s.sized(a[0]), s.sized(a[1])); }},
      {Op::kNeg, [](S s, I i, N a) { return size_within(i, s.of(a[0]).most, s.of(a[0]).stride); }},
      {Op::kMin, [](S s, I i, N a) { return either_size(i, s.sized(a[0]), s.sized(a[1])); }},
      {Op::kMax, [](S s, I i, N a) { return either_size(i, s.sized(a[0]), s.sized(a[1])); }},
      {Op::kAbs, [](S s, I i, N a) { return size_within(i, 2 * s.of(a[0]).most, 1); }},
      {Op::kIteInt, [](S s, I i, N a) { return either_size(i, s.sized(a[1]), s.sized(a[2])); }},
  };
  // clang-format on
};

namespace {

constexpr std::array<OrderSizingRow, kOpCount> kSizings = by_operation(OrderSizings::kRows);

}  // namespace

bool OrderSizes::meet_new_nodes() {
  const auto known = static_cast<std::uint32_t>(sizes_.size());
  if (known == graph_.size()) return false;
  sizes_.resize(graph_.size());
  count_comparisons(known);
  find_sizes(known);
  const std::vector<std::size_t> in_bits =
      wide_choices_in_bits(graph_, known, [this](NodeId node) { return of(node); });
  for (const std::size_t variable : in_bits) choices_.write_in_bits(variable);
  if (!in_bits.empty()) find_sizes(known);
  return true;
}

/// Counts the comparisons of each sum among the nodes from the first one on.
void OrderSizes::count_comparisons(std::uint32_t first) {
  for (std::uint32_t i = first; i < graph_.size(); ++i) {
    const Graph::Node& node = graph_.node({i});
    if (node.op != Op::kEqInt && node.op != Op::kLtInt && node.op != Op::kLeInt) continue;
    for (const NodeId operand : node.args()) {
      const Op op = graph_.node(operand).op;
      if (op == Op::kAdd || op == Op::kSub) ++comparisons_[operand.index];
    }
  }
}

/// Operands are older than what uses them.
void OrderSizes::find_sizes(std::uint32_t first) {
  for (std::uint32_t i = first; i < graph_.size(); ++i) {
    if (graph_.node({i}).type() != Type::kInt) continue;
    const OrderSize size = computed({i});
    if (size.is_ordered() || of({i}).is_ordered()) sizes_[i] = size;
  }
}

OrderSize OrderSizes::computed(NodeId id) const {
  const Graph::Node& node = graph_.node(id);
  const OrderSizing sizing = kSizings[static_cast<std::size_t>(node.op)].size;
  OrderSize size;
  if (sizing != nullptr) size = sizing(*this, node.interval, operands_or_itself(node, id));
  const auto comparisons = comparisons_.find(id.index);
  if (size.is_ordered() || comparisons == comparisons_.end()) return size;
  return compared_sum_size(node.interval, of(node.operands[0]), of(node.operands[1]), comparisons->second);
}

}  // namespace solitaire
