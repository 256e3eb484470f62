#pragma once
#include <cstdint>
#include <vector>

#include "solitaire/run/selection.h"

namespace solitaire {

/// The layer of an evaluation that gives the operators of the language their meaning, on values of all kinds.
class Operators : public Selection {
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
  /// min, max: of two numbers.
  Value pick(Op int_op, const Value& a, const Value& b, Span span);
  Value make_list(std::vector<Value> items, Span span);

 protected:
  using Selection::Selection;

  /// Bounds how deep lists and records nest in a value.
  void check_nesting(const Value& value, Span span);

 private:
  /// Unset where the operation has no value.
  static Value on_ints(BinaryOp op, std::int64_t a, std::int64_t b);
  Value on_values(BinaryOp op, const Value& a, const Value& b, Span span);
  Value arithmetic_shaped(BinaryOp op, const Value& a, const Value& b, Span span);
  Value int_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span);
  Value float_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span);
  Value joined_lists(const Value& a, const Value& b, Span span);
  Value joined(const Value& a, const Value& b, Span span);
};

}  // namespace solitaire
