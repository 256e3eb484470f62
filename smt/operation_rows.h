#pragma once
#include <array>
#include <cstddef>

#include "tracegraph/graph.h"

namespace solitaire {

/// Returns a table with the row of each operation at its place. `Row` has a member `op`; operations without a
/// row among those given get an empty one.
template <class Row, std::size_t Count>
constexpr std::array<Row, kOpCount> by_operation(const Row (&rows)[Count]) {
  std::array<Row, kOpCount> table{};
  for (const Row& row : rows) table[static_cast<std::size_t>(row.op)] = row;
  return table;
}

/// Returns true if bit-vectors can express the operation. It says what Operation::on_floats denies, where a
/// constant expression is needed.
constexpr bool has_bits(Op op) {
  return op < Op::kToFloat && op != Op::kConstFloat && op != Op::kChoiceFloat;
}

/// Returns true if the rows are those of all operations that compute something bit-vectors can express, each
/// once. Leaves may have a row or not.
template <class Row, std::size_t Count>
constexpr bool cover_all_operations(const Row (&rows)[Count]) {
  for (std::size_t i = 0; i < kOpCount; ++i) {
    const Op op = static_cast<Op>(i);
    std::size_t count = 0;
    for (const Row& row : rows) count += row.op == op ? 1 : 0;
    const bool is_leaf = op <= Op::kChoiceFloat;
    if (count > 1 || (!is_leaf && (count == 1) != has_bits(op))) return false;
  }
  return true;
}

/// Returns what the function of a row gets of a node: its operands or, of a leaf, itself.
inline const NodeId* operands_or_itself(const Graph::Node& node, const NodeId& id) {
  return operation(node.op).arity == 0 ? &id : node.operands.data();
}

}  // namespace solitaire
