#include "solitaire/run/operators.h"

#include <fmt/format.h>

#include "solitaire/run/binary_meaning.h"
#include "solitaire/value/chosen_list.h"
#include "solitaire/value/elements.h"
#include "solitaire/value/joined.h"

namespace solitaire {
namespace {

/// How deep lists and records may nest in each other.
constexpr std::uint32_t kDeepestValue = 500;

}  // namespace

// ---- binary operators

Value Operators::on_ints(BinaryOp op, std::int64_t a, std::int64_t b) {
  const BinaryMeaning& meaning = meaning_of(op);
  const Operation& row = operation(meaning.on_ints);
  const Scalar operands[] = {Scalar::of(meaning.swapped ? b : a), Scalar::of(meaning.swapped ? a : b)};
  const auto result = row.fold(operands);
  if (!result) return {};
  if (row.result == Type::kBool) return (result->i != 0) != meaning.negated;
  return result->i;
}

Value Operators::on_values(BinaryOp op, const Value& a, const Value& b, Span span) {
  switch (op) {
    case BinaryOp::kEqual:
      return equal(a, b, span);
    case BinaryOp::kNotEqual:
      return invert(equal(a, b, span));
    case BinaryOp::kLess:
    case BinaryOp::kLessEqual:
    case BinaryOp::kGreater:
    case BinaryOp::kGreaterEqual:
      return compare(op, a, b, span);
    default:
      return arithmetic(op, a, b, span);
  }
}

// ---- arithmetic

Value Operators::arithmetic(BinaryOp op, const Value& a, const Value& b, Span span) {
  if (a.has_type(Type::kInt) && b.has_type(Type::kInt)) return int_arithmetic(op, a, b, span);
  if (op == BinaryOp::kAdd && is_text(a) && is_text(b)) return joined(a, b, span);
  if (a.as_union() == nullptr && b.as_union() == nullptr) return arithmetic_shaped(op, a, b, span);
  return each_shape(a, b, [&](const Value& x, const Value& y) { return arithmetic_shaped(op, x, y, span); });
}

Value Operators::arithmetic_shaped(BinaryOp op, const Value& a, const Value& b, Span span) {
  if (a.is_number() && b.is_number()) {
    const bool ints = a.has_type(Type::kInt) && b.has_type(Type::kInt);
    return ints ? int_arithmetic(op, a, b, span) : float_arithmetic(op, a, b, span);
  }
  if (op == BinaryOp::kAdd && a.is_list() && b.is_list()) return joined_lists(a, b, span);
  if (op == BinaryOp::kAdd && is_one_string(a) && is_one_string(b))
    return is_text(a) && is_text(b) ? joined(a, b, span) : opaque_string(span);
  std::string help;
  if (a.object<String>() != nullptr || b.object<String>() != nullptr)
    help = "str(x) makes a string of a value";
  if (a.is_list() || b.is_list()) help = "put an element into brackets to join it to a list: xs + [x]";
  program_error(
      span, fmt::format("'{}' does not go with {} and {}", meaning_of(op).symbol, describe(a), describe(b)),
      op == BinaryOp::kAdd ? help : "");
}

Value Operators::joined_lists(const Value& a, const Value& b, Span span) {
  step(span, Elements(a).size() + Elements(b).size());
  if (!a.is<List>() || !b.is<List>()) return concatenate_lists(a, b);
  const std::vector<Value>& first = a.as_list()->items;
  const std::vector<Value>& second = b.as_list()->items;
  std::vector<Value> items;
  items.reserve(first.size() + second.size());
  items = first;
  items.insert(items.end(), second.begin(), second.end());
  return make_list(std::move(items), span);
}

/// One text behind the other. It counts as many steps as an execution makes at most.
Value Operators::joined(const Value& a, const Value& b, Span span) {
  step(span, sizes(a).most + sizes(b).most);
  Value text = concatenate(a, b, span);
  if (nesting(text) > kDeepestValue) {
    unsupported(span, fmt::format("this text depends on more than {} choices about its parts", kDeepestValue),
                "make it of fewer parts that may be missing");
  }
  return text;
}

Value Operators::int_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span) {
  const bool divides = op == BinaryOp::kDivide || op == BinaryOp::kModulo;
  if (divides) {
    const std::int64_t* divisor = b.plain<std::int64_t>();
    if (divisor == nullptr) {
      require(invert(binary(Op::kEqInt, b, std::int64_t{0}, span)), ConstraintKind::kDivisor, span);
    } else if (*divisor == 0) {
      reject(ConstraintKind::kDivisor, span);
    }
  }
  return int_operation(meaning_of(op).on_ints, a, b, span);
}

Value Operators::float_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span) {
  const BinaryMeaning& row = meaning_of(op);
  if (!row.on_floats) {
    program_error(span,
                  fmt::format("'{}' is for ints, here are {} and {}", row.symbol, describe(a), describe(b)));
  }
  const Value x = to_float(a, span);
  const Value y = to_float(b, span);
  if (op == BinaryOp::kDivide) require(invert(equal(b, std::int64_t{0})), ConstraintKind::kDivisor, span);
  return binary(*row.on_floats, x, y, span);
}

Value Operators::negated(const Value& value, Span span) {
  return each_shape(value, [&](const Value& one) -> Value {
    if (!one.is_number()) program_error(span, fmt::format("'-' does not go with {}", describe(one)));
    return unary(one.has_type(Type::kInt) ? Op::kNeg : Op::kNegFloat, one, span);
  });
}

Value Operators::pick(Op int_op, const Value& a, const Value& b, Span span) {
  if (a.as_union() != nullptr || b.as_union() != nullptr) {
    return each_shape(a, b, [&](const Value& x, const Value& y) { return pick(int_op, x, y, span); });
  }
  if (!a.is_number() || !b.is_number()) {
    program_error(span, fmt::format("'{}' needs numbers, here is {}", operation(int_op).name,
                                    describe(a.is_number() ? b : a)));
  }
  if (a.has_type(Type::kInt) && b.has_type(Type::kInt)) return int_operation(int_op, a, b, span);
  const Value smaller = compare(BinaryOp::kLessEqual, a, b, span);
  return select(int_op == Op::kMin ? smaller : invert(smaller), to_float(a, span), to_float(b, span), span);
}

// ---- lists and texts

Value Operators::make_list(std::vector<Value> items, Span span) {
  Value list = Value::list(std::move(items));
  check_nesting(list, span);
  return list;
}

void Operators::check_nesting(const Value& value, Span span) {
  if (nesting(value) > kDeepestValue) {
    program_error(span, fmt::format("lists and records nest more than {} deep", kDeepestValue),
                  "to join lists, use xs + ys");
  }
}

}  // namespace solitaire
