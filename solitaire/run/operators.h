#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solitaire/run/constraints.h"

namespace solitaire {

/// The layer of an evaluation that computes: arithmetic, comparison and selection, on constants, on nodes of
/// the graph, and on constants that carry nodes. What an operation means stands in the table of operations.
class Operators : public Constraints {
 public:
  /// What a binary operator other than a..b gives.
  Value operate(BinaryOp op, const Value& a, const Value& b, Span span) {
    const std::int64_t* x = a.plain<std::int64_t>();
    const std::int64_t* y = b.plain<std::int64_t>();
    if (x != nullptr && y != nullptr) {
      Value result = on_ints(op, *x, *y);
      if (given(result)) return result;
    }
    return on_values(op, a, b, span);
  }
  Value arithmetic(BinaryOp op, const Value& a, const Value& b, Span span);
  Value negated(const Value& value, Span span);
  Value compare(BinaryOp op, const Value& a, const Value& b, Span span);
  /// Structural equality, as a bool. It takes a step for each pair of members, which count at `span`.
  Value equal(const Value& a, const Value& b, Span span = {});
  Value invert(const Value& condition) {
    if (const bool* known = condition.plain<bool>()) return !*known;
    return unary(Op::kNot, condition, {});
  }
  Value opaque_string(Span span);
  /// For what needs to know what a string says.
  void check_known(const Value& text);
  /// The conjunction of two bools that are no unions.
  Value both(const Value& a, const Value& b) {
    if (const bool* known = a.plain<bool>()) return *known ? b : a;
    if (const bool* known = b.plain<bool>()) return *known ? a : b;
    return binary(Op::kAnd, a, b, {});
  }
  Value either(const Value& a, const Value& b) {
    if (const bool* known = a.plain<bool>()) return *known ? a : b;
    return invert(both(invert(a), invert(b)));
  }
  /// `a` if the condition, a bool, holds, else `b`; both have been evaluated.
  Value select(const Value& condition, const Value& a, const Value& b, Span span) {
    if (const bool* known = condition.plain<bool>()) return *known ? a : b;
    return select_open(condition, a, b, span);
  }
  /// The value, for a use that depends on what exactly it is: a traced execution is one of those in which it
  /// is the same.
  const Value& fixed(const Value& value, Span span);
  /// min, max: of two numbers.
  Value pick(Op int_op, const Value& a, const Value& b, Span span);
  Value to_float(const Value& number, Span span);
  Value make_list(std::vector<Value> items, Span span);
  /// An operation on numbers of its operand type.
  Value unary(Op op, const Value& value, Span span) { return on_table(op, {&value, 1}, span); }
  Value binary(Op op, const Value& a, const Value& b, Span span) {
    const Value operands[] = {a, b};
    return on_table(op, operands, span);
  }

 protected:
  using Constraints::Constraints;

  /// Bounds how deep lists and records nest in a value.
  void check_nesting(const Value& value, Span span);
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
  /// Unset where the operation has no value.
  static Value on_ints(BinaryOp op, std::int64_t a, std::int64_t b);
  Value on_values(BinaryOp op, const Value& a, const Value& b, Span span);
  Value select_open(const Value& condition, const Value& a, const Value& b, Span span);
  Value arithmetic_shaped(BinaryOp op, const Value& a, const Value& b, Span span);
  Value int_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span);
  Value float_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span);
  Value on_table(Op op, std::span<const Value> operands, Span span);
  Value fold(Op op, std::span<const Value> operands, Span span);
  NodeId node_of_operation(Op op, std::span<const Value> operands, Span span);
  std::vector<Value> select_members(const Value& condition, const std::vector<Value>& a,
                                    const std::vector<Value>& b, Span span);
  Value joined_lists(const Value& a, const Value& b, Span span);
  Value joined(const Value& a, const Value& b, Span span);
  Value equal_texts(const Value& a, const Value& b);
  Value equal_shaped(const Value& a, const Value& b, Span span);
  Value equal_members(const std::vector<Value>& a, const std::vector<Value>& b, Span span);
  Value equal_lists(const Value& a, const Value& b, Span span);
  /// An int, constant or not, against a constant float: exactly, without making a float of the int.
  Value int_equals(const Value& a, double b);
  Value int_below(const Value& a, double b, bool strict, Span span);
  Value int_above(const Value& a, double b, bool strict, Span span);
  [[noreturn]] void too_large(Span span);
};

}  // namespace solitaire
