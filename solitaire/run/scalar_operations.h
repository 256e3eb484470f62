#pragma once
#include <cstdint>
#include <span>

#include "solitaire/run/constraints.h"

namespace solitaire {

/// The layer of an evaluation that applies operations of the table to single bools, ints and floats: to
/// constants, to nodes of the graph, and to constants that carry nodes. None of its operands is a union.
class ScalarOperations : public Constraints {
 public:
  /// An operation on numbers of its operand type.
  Value unary(Op op, const Value& value, Span span) { return on_table(op, {&value, 1}, span); }
  Value binary(Op op, const Value& a, const Value& b, Span span) {
    const Value operands[] = {a, b};
    return on_table(op, operands, span);
  }
  Value to_float(const Value& number, Span span);
  Value invert(const Value& condition) {
    if (const bool* known = condition.plain<bool>()) return !*known;
    return unary(Op::kNot, condition, {});
  }
  Value both(const Value& a, const Value& b) {
    if (const bool* known = a.plain<bool>()) return *known ? b : a;
    if (const bool* known = b.plain<bool>()) return *known ? a : b;
    return binary(Op::kAnd, a, b, {});
  }
  Value either(const Value& a, const Value& b) {
    if (const bool* known = a.plain<bool>()) return *known ? a : b;
    return invert(both(invert(a), invert(b)));
  }

 protected:
  using Constraints::Constraints;

  /// A comparison in the program of two ints.
  Value int_comparison(Op op, const Value& a, const Value& b, Span span) {
    if (!keeps_comparisons()) return int_operation(op, a, b, span);
    return value_of(*graph_, graph_->open_comparison(op, node_of(*graph_, a), node_of(*graph_, b)));
  }
  /// An operation of the table on two ints, constants or not.
  Value int_operation(Op op, const Value& a, const Value& b, Span span) {
    const std::int64_t* x = a.plain<std::int64_t>();
    const std::int64_t* y = b.plain<std::int64_t>();
    if (x == nullptr || y == nullptr) return binary(op, a, b, span);
    const Scalar operands[] = {Scalar::of(*x), Scalar::of(*y)};
    const Operation& row = operation(op);
    const auto result = row.fold(operands);
    if (!result) too_large(span);
    if (row.result == Type::kBool) return result->i != 0;
    return result->i;
  }

 private:
  Value on_table(Op op, std::span<const Value> operands, Span span);
  Value fold(Op op, std::span<const Value> operands, Span span);
  NodeId node_of_operation(Op op, std::span<const Value> operands, Span span);
  [[noreturn]] void too_large(Span span);
};

}  // namespace solitaire
