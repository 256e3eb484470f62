#include "engines/count/nested/columns.h"

#include <algorithm>

namespace solitaire {

bool fits_column(const Graph& graph, NodeId node) {
  const Graph::Node& data = graph.node(node);
  if (data.op == Op::kConstTable) return true;
  return !data.has_float && data.interval.lo >= INT32_MIN && data.interval.hi <= INT32_MAX;
}

void compute_column(const Graph& graph, NodeId node, const std::array<const std::int32_t*, 3>& operands,
                    std::size_t size, std::int32_t* result) {
  const auto [a, b, c] = operands;
  const auto for_all = [&](auto compute) {
    for (std::size_t i = 0; i < size; ++i) result[i] = compute(i);
  };
  const Graph::Node& data = graph.node(node);
  switch (data.op) {
    case Op::kNot:
      return for_all([a = a](std::size_t i) { return a[i] ^ 1; });
    case Op::kAnd:
      return for_all([a = a, b = b](std::size_t i) { return a[i] & b[i]; });
    case Op::kOr:
      return for_all([a = a, b = b](std::size_t i) { return a[i] | b[i]; });
    case Op::kIteBool:
    case Op::kIteInt:
      return for_all([a = a, b = b, c = c](std::size_t i) { return a[i] != 0 ? b[i] : c[i]; });
    case Op::kAdd:
      return for_all([a = a, b = b](std::size_t i) { return a[i] + b[i]; });
    case Op::kSub:
      return for_all([a = a, b = b](std::size_t i) { return a[i] - b[i]; });
    case Op::kEqBool:
    case Op::kEqInt:
      return for_all([a = a, b = b](std::size_t i) -> std::int32_t { return a[i] == b[i]; });
    case Op::kLtInt:
      return for_all([a = a, b = b](std::size_t i) -> std::int32_t { return a[i] < b[i]; });
    case Op::kLeInt:
      return for_all([a = a, b = b](std::size_t i) -> std::int32_t { return a[i] <= b[i]; });
    default:
      break;
  }
  const std::span<const NodeId> args = data.args();
  for_all([&](std::size_t i) {
    std::array<Scalar, 3> values{};
    for (std::size_t k = 0; k < args.size(); ++k)
      values[k] = graph.node(args[k]).is_constant() ? graph.scalar(args[k])
                                                    : Scalar::of(std::int64_t{operands[k][i]});
    const std::optional<Scalar> value = operation(data.op).fold(values.data());
    return value ? static_cast<std::int32_t>(value->i) : 0;
  });
}

}  // namespace solitaire
