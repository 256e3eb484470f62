#include <fmt/format.h>

#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

struct Arithmetic {
  BinaryOp op;
  const char* symbol;
  Op on_ints;
  std::optional<Op> on_floats;
};

constexpr Arithmetic kArithmetic[] = {
    {BinaryOp::kAdd, "+", Op::kAdd, Op::kAddFloat},      {BinaryOp::kSubtract, "-", Op::kSub, Op::kSubFloat},
    {BinaryOp::kMultiply, "*", Op::kMul, Op::kMulFloat}, {BinaryOp::kDivide, "/", Op::kDiv, Op::kDivFloat},
    {BinaryOp::kModulo, "%", Op::kMod, std::nullopt},
};

const Arithmetic& arithmetic_of(BinaryOp op) { return kArithmetic[static_cast<std::size_t>(op)]; }

const char* comparison_symbol(BinaryOp op) {
  switch (op) {
    case BinaryOp::kLess:
      return "<";
    case BinaryOp::kLessEqual:
      return "<=";
    case BinaryOp::kGreater:
      return ">";
    default:
      return ">=";
  }
}

bool constant(const Value& value) { return !value.is<Symbol>(); }

}  // namespace

Value Evaluator::arithmetic(BinaryOp op, const Value& a, const Value& b, Span span) {
  if (a.has_type(Type::kInt) && b.has_type(Type::kInt)) return int_arithmetic(op, a, b, span);
  if (a.as_union() == nullptr && b.as_union() == nullptr) return arithmetic_shaped(op, a, b, span);
  return each_shape(a, [&](const Value& x) {
    return each_shape(b, [&](const Value& y) { return arithmetic_shaped(op, x, y, span); });
  });
}

Value Evaluator::arithmetic_shaped(BinaryOp op, const Value& a, const Value& b, Span span) {
  if (a.is_number() && b.is_number()) {
    const bool ints = a.has_type(Type::kInt) && b.has_type(Type::kInt);
    return ints ? int_arithmetic(op, a, b, span) : float_arithmetic(op, a, b, span);
  }
  if (op == BinaryOp::kAdd && a.as_list() != nullptr && b.as_list() != nullptr) {
    std::vector<Value> items = a.as_list()->items;
    items.insert(items.end(), b.as_list()->items.begin(), b.as_list()->items.end());
    step(span, items.size());
    return make_list(std::move(items), span);
  }
  if (op == BinaryOp::kAdd && a.object<String>() != nullptr && b.object<String>() != nullptr) {
    std::string text = a.object<String>()->text + b.object<String>()->text;
    step(span, text.size());
    if (!is_known(a) || !is_known(b)) return opaque_string(span);
    return Value::string(std::move(text));
  }
  std::string help;
  if (a.object<String>() != nullptr || b.object<String>() != nullptr)
    help = "str(x) makes a string of a value";
  if (a.as_list() != nullptr || b.as_list() != nullptr)
    help = "put an element into brackets to join it to a list: xs + [x]";
  program_error(
      span,
      fmt::format("'{}' does not go with {} and {}", arithmetic_of(op).symbol, describe(a), describe(b)),
      op == BinaryOp::kAdd ? help : "");
}

Value Evaluator::int_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span) {
  const bool divides = op == BinaryOp::kDivide || op == BinaryOp::kModulo;
  if (divides && constant(b) && *b.get<std::int64_t>() == 0) reject(ConstraintKind::kDivisor, span);
  if (divides && !constant(b)) {
    const NodeId divisor = node_of(graph_, b);
    const NodeId zero = graph_.constant(std::int64_t{0});
    require(graph_.negation(graph_.apply(Op::kEqInt, {divisor, zero})), ConstraintKind::kDivisor, span);
  }
  return apply_value(arithmetic_of(op).on_ints, a, b, span);
}

/// An int operation on constants, without the graph, or on nodes.
Value Evaluator::apply_value(Op op, const Value& a, const Value& b, Span span) {
  if (constant(a) && constant(b)) {
    const Scalar operands[] = {Scalar::of(*a.get<std::int64_t>()), Scalar::of(*b.get<std::int64_t>())};
    const Operation& row = operation(op);
    const auto result = row.fold(operands);
    if (!result) {
      program_error(span, "this int grows past 62 bits", "ints lie between -(2^62 - 1) and 2^62 - 1");
    }
    if (row.result == Type::kBool) return result->i != 0;
    return result->i;
  }
  return value_of(graph_, apply(op, {node_of(graph_, a), node_of(graph_, b)}, span));
}

NodeId Evaluator::float_node(const Value& number, Span span) {
  const NodeId node = node_of(graph_, number);
  return number.has_type(Type::kFloat) ? node : apply(Op::kToFloat, {node}, span);
}

Value Evaluator::to_float(const Value& number, Span span) {
  if (const auto* i = number.get<std::int64_t>()) return static_cast<double>(*i);
  if (number.is<double>()) return number;
  return value_of(graph_, float_node(number, span));
}

Value Evaluator::float_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span) {
  const Arithmetic& row = arithmetic_of(op);
  if (!row.on_floats) {
    program_error(span,
                  fmt::format("'{}' is for ints, here are {} and {}", row.symbol, describe(a), describe(b)));
  }
  const Value x = to_float(a, span);
  const Value y = to_float(b, span);
  if (op == BinaryOp::kDivide) {
    require(condition(invert(equal(b, std::int64_t{0})), span), ConstraintKind::kDivisor, span);
  }
  if (constant(x) && constant(y)) {
    const Scalar operands[] = {Scalar::of(*x.get<double>()), Scalar::of(*y.get<double>())};
    return operation(*row.on_floats).fold(operands)->f;
  }
  return value_of(graph_, apply(*row.on_floats, {node_of(graph_, x), node_of(graph_, y)}, span));
}

Value Evaluator::negated(const Value& value, Span span) {
  if (const auto* i = value.get<std::int64_t>()) return -*i;
  if (const auto* d = value.get<double>()) return -*d;
  return each_shape(value, [&](const Value& one) -> Value {
    if (!one.is_number()) program_error(span, fmt::format("'-' does not go with {}", describe(one)));
    const Op op = one.has_type(Type::kInt) ? Op::kNeg : Op::kNegFloat;
    return value_of(graph_, apply(op, {node_of(graph_, one)}, span));
  });
}

Value Evaluator::unary(Op op, const Value& value, Span span) {
  const Operation& row = operation(op);
  if (constant(value)) {
    const Scalar operand =
        row.operand == Type::kInt ? Scalar::of(*value.get<std::int64_t>()) : Scalar::of(*value.get<double>());
    const auto result = row.fold(&operand);
    if (!result) program_error(span, fmt::format("'{}' of {} has no value", row.name, to_text(value)));
    if (row.result == Type::kInt) return result->i;
    return result->f;
  }
  return value_of(graph_, apply(op, {node_of(graph_, value)}, span));
}

Value Evaluator::pick(Op int_op, const Value& a, const Value& b, Span span) {
  if (a.as_union() != nullptr || b.as_union() != nullptr) {
    return each_shape(a, [&](const Value& x) {
      return each_shape(b, [&](const Value& y) { return pick(int_op, x, y, span); });
    });
  }
  if (!a.is_number() || !b.is_number()) {
    program_error(span, fmt::format("'{}' needs numbers, here is {}", operation(int_op).name,
                                    describe(a.is_number() ? b : a)));
  }
  if (a.has_type(Type::kInt) && b.has_type(Type::kInt)) return apply_value(int_op, a, b, span);
  const Value smaller = compare(BinaryOp::kLessEqual, a, b, span);
  const NodeId first =
      int_op == Op::kMin ? condition(smaller, span) : graph_.negation(condition(smaller, span));
  return merge(graph_, first, to_float(a, span), to_float(b, span));
}

Value Evaluator::compare(BinaryOp op, const Value& a, const Value& b, Span span) {
  if (a.as_union() != nullptr || b.as_union() != nullptr) {
    return each_shape(a, [&](const Value& x) {
      return each_shape(b, [&](const Value& y) { return compare(op, x, y, span); });
    });
  }
  if (!a.is_number() || !b.is_number()) {
    program_error(span, fmt::format("'{}' compares numbers, here are {} and {}", comparison_symbol(op),
                                    describe(a), describe(b)));
  }
  const bool swapped = op == BinaryOp::kGreater || op == BinaryOp::kGreaterEqual;
  const bool strict = op == BinaryOp::kLess || op == BinaryOp::kGreater;
  const Value& left = swapped ? b : a;
  const Value& right = swapped ? a : b;
  if (left.has_type(Type::kInt) && right.has_type(Type::kInt)) {
    return apply_value(strict ? Op::kLtInt : Op::kLeInt, left, right, span);
  }
  const Value x = to_float(left, span);
  const Value y = to_float(right, span);
  if (constant(x) && constant(y)) {
    return strict ? *x.get<double>() < *y.get<double>() : *x.get<double>() <= *y.get<double>();
  }
  return value_of(
      graph_, apply(strict ? Op::kLtFloat : Op::kLeFloat, {node_of(graph_, x), node_of(graph_, y)}, span));
}

Value Evaluator::invert(const Value& condition) {
  if (const bool* known = condition.get<bool>()) return !*known;
  return value_of(graph_, graph_.negation(node_of(graph_, condition)));
}

Value Evaluator::both(const Value& a, const Value& b) {
  if (const bool* known = a.get<bool>()) return *known ? b : a;
  if (const bool* known = b.get<bool>()) return *known ? a : b;
  return value_of(graph_, graph_.conjunction(node_of(graph_, a), node_of(graph_, b)));
}

Value Evaluator::either(const Value& a, const Value& b) { return invert(both(invert(a), invert(b))); }

/// A text that only the replay of a solution knows; `span` is what makes it.
Value Evaluator::opaque_string(Span span) {
  Ref<String> text = make_ref<String>("?");
  text->opaque = span;
  return text;
}

void Evaluator::check_known(const Value& text) {
  if (const auto& opaque = text.object<String>()->opaque) {
    unsupported(*opaque, "this text depends on choices, and the program looks at what it says",
                "look at the values that it is made of");
  }
}

Value Evaluator::equal(const Value& a, const Value& b) {
  if (a.as_union() == nullptr && b.as_union() == nullptr) return equal_shaped(a, b);
  return each_shape(
      a, [&](const Value& x) { return each_shape(b, [&](const Value& y) { return equal_shaped(x, y); }); });
}

Value Evaluator::equal_shaped(const Value& a, const Value& b) {
  if (a.is_number() && b.is_number()) {
    if (const auto* x = a.get<std::int64_t>()) {
      if (const auto* y = b.get<std::int64_t>()) return *x == *y;
    }
    if (a.has_type(Type::kInt) && b.has_type(Type::kInt)) {
      return value_of(graph_, graph_.apply(Op::kEqInt, {node_of(graph_, a), node_of(graph_, b)}));
    }
    const Value x = to_float(a, {});
    const Value y = to_float(b, {});
    if (constant(x) && constant(y)) return *x.get<double>() == *y.get<double>();
    return value_of(graph_, graph_.apply(Op::kEqFloat, {node_of(graph_, x), node_of(graph_, y)}));
  }
  if (a.has_type(Type::kBool) && b.has_type(Type::kBool)) {
    if (constant(a) && constant(b)) return *a.get<bool>() == *b.get<bool>();
    return value_of(graph_, graph_.apply(Op::kEqBool, {node_of(graph_, a), node_of(graph_, b)}));
  }
  if (const List* list = a.as_list(); list != nullptr && b.as_list() != nullptr) {
    return equal_members(list->items, b.as_list()->items);
  }
  if (const Record* record = a.object<Record>(); record != nullptr && b.object<Record>() != nullptr) {
    const Record* other = b.object<Record>();
    return record->type == other->type ? equal_members(record->fields, other->fields) : Value(false);
  }
  if (a.object<String>() != nullptr && b.object<String>() != nullptr) {
    check_known(a);
    check_known(b);
  }
  return same(a, b);
}

Value Evaluator::equal_members(const std::vector<Value>& a, const std::vector<Value>& b) {
  if (a.size() != b.size()) return false;
  Value all = true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    all = both(all, equal(a[i], b[i]));
    if (const bool* known = all.get<bool>(); known != nullptr && !*known) return false;
  }
  return all;
}

NodeId Evaluator::condition(const Value& value, Span span) {
  if (const bool* known = value.get<bool>()) return *known ? kTrue : kFalse;
  if (const Symbol* symbol = value.get<Symbol>(); symbol != nullptr && symbol->type == Type::kBool)
    return symbol->node;
  const Value checked = each_shape(value, [&](const Value& one) {
    if (!one.has_type(Type::kBool)) {
      program_error(span, fmt::format("a condition is true or false, not {}", describe(one)),
                    one.has_type(Type::kInt) ? "compare it with something: x != 0" : "");
    }
    return one;
  });
  return node_of(graph_, checked);
}

}  // namespace solitaire
