#include "solitaire/run/operators.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "solitaire/value/chosen_list.h"
#include "solitaire/value/elements.h"
#include "solitaire/value/joined.h"

namespace solitaire {
namespace {

/// What a binary operator means on numbers: an operation of the table, its operands swapped or its result
/// negated.
struct BinaryMeaning {
  const char* symbol;
  Op on_ints;
  std::optional<Op> on_floats;
  bool swapped = false;
  bool negated = false;
};

constexpr bool kSwapped = true;
constexpr bool kNegated = true;

/// In the order of BinaryOp, up to the comparisons.
constexpr BinaryMeaning kMeanings[] = {
    {"+", Op::kAdd, Op::kAddFloat},
    {"-", Op::kSub, Op::kSubFloat},
    {"*", Op::kMul, Op::kMulFloat},
    {"/", Op::kDiv, Op::kDivFloat},
    {"%", Op::kMod, std::nullopt},
    {"==", Op::kEqInt, Op::kEqFloat},
    {"!=", Op::kEqInt, Op::kEqFloat, !kSwapped, kNegated},
    {"<", Op::kLtInt, Op::kLtFloat},
    {"<=", Op::kLeInt, Op::kLeFloat},
    {">", Op::kLtInt, Op::kLtFloat, kSwapped},
    {">=", Op::kLeInt, Op::kLeFloat, kSwapped},
};
static_assert(std::size(kMeanings) == static_cast<std::size_t>(BinaryOp::kGreaterEqual) + 1);

const BinaryMeaning& meaning_of(BinaryOp op) { return kMeanings[static_cast<std::size_t>(op)]; }

/// Returns true if two values that are not both numbers or both bools are of one kind.
bool are_alike(const Value& a, const Value& b) {
  if (a.is<Symbol>() || b.is<Symbol>()) return false;
  return a.kind() == b.kind() || (is_one_string(a) && is_one_string(b)) ||
         (a.is_function() && b.is_function());
}

bool constant(const Value& value) { return !value.is<Symbol>(); }
bool is_scalar(const Value& value) { return value.has_type(Type::kBool) || value.is_number(); }

Scalar scalar_of(const Value& value) {
  if (const bool* b = value.get<bool>()) return Scalar::of(*b);
  if (const std::int64_t* i = value.get<std::int64_t>()) return Scalar::of(*i);
  return Scalar::of(*value.get<double>());
}

Value value_of_scalar(Type type, Scalar scalar) {
  switch (type) {
    case Type::kBool:
      return scalar.i != 0;
    case Type::kInt:
      return scalar.i;
    case Type::kFloat:
      break;
  }
  return scalar.f;
}

Value without_node(const Value& value) {
  if (const bool* b = value.get<bool>()) return *b;
  if (const std::int64_t* i = value.get<std::int64_t>()) return *i;
  return *value.get<double>();
}

/// Returns the int of the language that is the same number, if there is one.
std::optional<std::int64_t> int_of(double number) {
  constexpr double kPastAll = 0x1p62;
  if (!(std::abs(number) < kPastAll) || number != std::floor(number)) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

constexpr std::size_t kMostOperands = 2;

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

// ---- operations of the table

Value Operators::on_table(Op op, std::span<const Value> operands, Span span) {
  bool all_constant = true;
  bool any_traced = false;
  for (const Value& operand : operands) {
    all_constant = all_constant && constant(operand);
    any_traced = any_traced || operand.traced();
  }
  if (!all_constant) return value_of(*graph_, node_of_operation(op, operands, span));
  const Value result = fold(op, operands, span);
  return any_traced ? result.with_node(*graph_, node_of_operation(op, operands, span)) : result;
}

Value Operators::fold(Op op, std::span<const Value> operands, Span span) {
  const Operation& row = operation(op);
  Scalar scalars[kMostOperands] = {};
  for (std::size_t i = 0; i < operands.size(); ++i) scalars[i] = scalar_of(operands[i]);
  const auto result = row.fold(scalars);
  if (!result && row.operand == Type::kFloat) {
    const bool two = operands.size() == 2;
    if (two && op != Op::kPow && std::isfinite(scalars[0].f) && std::isfinite(scalars[1].f))
      program_error(span, "this float grows past the largest one, about 1.8e308");
    const std::string second = two ? " and " + to_text(operands[1]) : "";
    const auto name = row.symbol.empty() ? row.name : row.symbol;
    program_error(span, fmt::format("'{}' of {}{} has no value", name, to_text(operands[0]), second));
  }
  if (!result) too_large(span);
  return value_of_scalar(row.result, *result);
}

NodeId Operators::node_of_operation(Op op, std::span<const Value> operands, Span span) {
  const NodeId made = operands.size() == 1
                          ? apply(op, {node_of(*graph_, operands[0])}, span)
                          : apply(op, {node_of(*graph_, operands[0]), node_of(*graph_, operands[1])}, span);
  path_.facts.derive(made);
  return made;
}

void Operators::too_large(Span span) {
  program_error(span, "this int grows past 62 bits", "ints lie between -(2^62 - 1) and 2^62 - 1");
}

// ---- arithmetic

Value Operators::arithmetic(BinaryOp op, const Value& a, const Value& b, Span span) {
  if (a.has_type(Type::kInt) && b.has_type(Type::kInt)) return int_arithmetic(op, a, b, span);
  if (op == BinaryOp::kAdd && is_text(a) && is_text(b)) return joined(a, b, span);
  if (a.as_union() == nullptr && b.as_union() == nullptr) return arithmetic_shaped(op, a, b, span);
  return each_shape(a, [&](const Value& x) {
    return each_shape(b, [&](const Value& y) { return arithmetic_shaped(op, x, y, span); });
  });
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

Value Operators::to_float(const Value& number, Span span) {
  if (const auto* i = number.plain<std::int64_t>()) return static_cast<double>(*i);
  return number.has_type(Type::kFloat) ? number : unary(Op::kToFloat, number, span);
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
    return each_shape(a, [&](const Value& x) {
      return each_shape(b, [&](const Value& y) { return pick(int_op, x, y, span); });
    });
  }
  if (!a.is_number() || !b.is_number()) {
    program_error(span, fmt::format("'{}' needs numbers, here is {}", operation(int_op).name,
                                    describe(a.is_number() ? b : a)));
  }
  if (a.has_type(Type::kInt) && b.has_type(Type::kInt)) return int_operation(int_op, a, b, span);
  const Value smaller = compare(BinaryOp::kLessEqual, a, b, span);
  return select(int_op == Op::kMin ? smaller : invert(smaller), to_float(a, span), to_float(b, span), span);
}

// ---- comparison

Value Operators::compare(BinaryOp op, const Value& a, const Value& b, Span span) {
  if (a.as_union() != nullptr || b.as_union() != nullptr) {
    return each_shape(a, [&](const Value& x) {
      return each_shape(b, [&](const Value& y) { return compare(op, x, y, span); });
    });
  }
  if (!a.is_number() || !b.is_number()) {
    program_error(span, fmt::format("'{}' compares numbers, here are {} and {}", meaning_of(op).symbol,
                                    describe(a), describe(b)));
  }
  const BinaryMeaning& meaning = meaning_of(op);
  const Value& left = meaning.swapped ? b : a;
  const Value& right = meaning.swapped ? a : b;
  if (left.has_type(Type::kInt) && right.has_type(Type::kInt))
    return int_comparison(meaning.on_ints, left, right, span);
  const bool strict = meaning.on_ints == Op::kLtInt;
  if (const double* known = right.plain<double>(); known != nullptr && left.has_type(Type::kInt))
    return int_below(left, *known, strict, span);
  if (const double* known = left.plain<double>(); known != nullptr && right.has_type(Type::kInt))
    return int_above(right, *known, strict, span);
  return binary(*meaning.on_floats, to_float(left, span), to_float(right, span), span);
}

Value Operators::equal(const Value& a, const Value& b, Span span) {
  if ((has_parts(a) || has_parts(b)) && is_text(a) && is_text(b)) return equal_texts(a, b);
  if (a.as_union() == nullptr && b.as_union() == nullptr) return equal_shaped(a, b, span);
  return each_shape(a, [&](const Value& x) {
    return each_shape(b, [&](const Value& y) { return equal_shaped(x, y, span); });
  });
}

/// Two strings of parts are compared part by part if these have the same sizes; else one is written out.
Value Operators::equal_texts(const Value& a, const Value& b) {
  if (const String* known = a.object<String>()) return value_of(*graph_, says(*graph_, b, known->text));
  if (const String* known = b.object<String>()) return value_of(*graph_, says(*graph_, a, known->text));
  if (sizes(a).most < sizes(b).least || sizes(b).most < sizes(a).least) return false;
  if (a.as_union() != nullptr)
    return each_alternative(a, [&](const Value& one) { return equal_texts(one, b); });
  if (b.as_union() != nullptr || !same_sizes(a, b))
    return each_shape(b, [&](const Value& one) { return equal_texts(a, one); });
  const auto& parts = a.object<Joined>()->parts;
  const auto& others = b.object<Joined>()->parts;
  Value all = true;
  for (std::size_t i = 0; i < parts.size(); ++i) all = both(all, equal(parts[i], others[i]));
  return all;
}

Value Operators::equal_shaped(const Value& a, const Value& b, Span span) {
  if (a.has_type(Type::kInt) && b.has_type(Type::kInt)) return int_comparison(Op::kEqInt, a, b, {});
  if (a.is_number() && b.is_number()) {
    if (a.has_type(Type::kInt) && b.plain<double>() != nullptr) return int_equals(a, *b.plain<double>());
    if (b.has_type(Type::kInt) && a.plain<double>() != nullptr) return int_equals(b, *a.plain<double>());
    return binary(Op::kEqFloat, to_float(a, {}), to_float(b, {}), {});
  }
  if (a.has_type(Type::kBool) && b.has_type(Type::kBool)) return binary(Op::kEqBool, a, b, {});
  if (const List* list = a.as_list(); list != nullptr && b.as_list() != nullptr) {
    return equal_members(list->items, b.as_list()->items, span);
  }
  const auto in_order = [this](const Value& list) {
    return list.is<ChosenList>() ? packed(*graph_, list) : list;
  };
  if (a.is_list() && b.is_list()) return equal_lists(in_order(a), in_order(b), span);
  if (const Record* record = a.object<Record>(); record != nullptr && b.object<Record>() != nullptr) {
    const Record* other = b.object<Record>();
    return record->type == other->type ? equal_members(record->fields, other->fields, span) : Value(false);
  }
  if (is_one_string(a) && is_one_string(b)) {
    check_known(a);
    check_known(b);
  }
  if (!are_alike(a, b)) effects_->compared_unlike(span);
  return same(a, b);
}

Value Operators::equal_members(const std::vector<Value>& a, const std::vector<Value>& b, Span span) {
  if (a.size() != b.size()) return false;
  Value all = true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    step(span);
    all = both(all, equal(a[i], b[i], span));
    if (const bool* known = all.plain<bool>(); known != nullptr && !*known) return false;
  }
  return all;
}

/// Of packed lists, one of which has a chosen length: as long, and with equal elements where both have them.
Value Operators::equal_lists(const Value& a, const Value& b, Span span) {
  const Elements x(a), y(b);
  Value all = true;
  for (std::size_t i = 0; i < std::max(x.size(), y.size()); ++i) {
    step(span);
    const Value in_a = i < x.size() ? value_of(*graph_, x.guard(i)) : Value(false);
    const Value in_b = i < y.size() ? value_of(*graph_, y.guard(i)) : Value(false);
    all = both(all, equal(in_a, in_b, span));
    if (i >= x.size() || i >= y.size()) continue;
    all = both(all, where(
                        both(in_a, in_b), span, [&] { return equal(x.value(i), y.value(i), span); }, true));
  }
  return all;
}

Value Operators::int_equals(const Value& a, double b) {
  const std::optional<std::int64_t> same = int_of(b);
  return same ? int_operation(Op::kEqInt, a, *same, {}) : Value(false);
}

Value Operators::int_below(const Value& a, double b, bool strict, Span span) {
  const std::optional<std::int64_t> end = int_of(strict ? std::ceil(b) : std::floor(b));
  return end ? int_operation(strict ? Op::kLtInt : Op::kLeInt, a, *end, span) : Value(b > 0);
}

Value Operators::int_above(const Value& a, double b, bool strict, Span span) {
  const std::optional<std::int64_t> end = int_of(strict ? std::floor(b) : std::ceil(b));
  return end ? int_operation(strict ? Op::kLtInt : Op::kLeInt, *end, a, span) : Value(b < 0);
}

// ---- conditions and selection

Value Operators::select_open(const Value& condition, const Value& a, const Value& b, Span span) {
  const bool* known = condition.get<bool>();
  if (known == nullptr) return merge(*graph_, node_of(*graph_, condition), a, b);
  const Value& selected = *known ? a : b;
  if (!condition.traced() || a.identical(b)) return selected;
  if (is_scalar(a) && a.kind() == b.kind()) {
    return selected.with_node(*graph_,
                              graph_->phi(condition.node(), node_of(*graph_, a), node_of(*graph_, b)));
  }
  const List* list = a.as_list();
  if (list != nullptr && b.as_list() != nullptr && list->items.size() == b.as_list()->items.size())
    return Value::list(select_members(condition, list->items, b.as_list()->items, span));
  const Record* record = a.object<Record>();
  if (record != nullptr && b.object<Record>() != nullptr && record->type == b.object<Record>()->type) {
    return make_ref<Record>(record->type,
                            select_members(condition, record->fields, b.object<Record>()->fields, span));
  }
  if (!same(a, b)) follow(condition, span);
  return selected;
}

std::vector<Value> Operators::select_members(const Value& condition, const std::vector<Value>& a,
                                             const std::vector<Value>& b, Span span) {
  std::vector<Value> selected;
  selected.reserve(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) selected.push_back(select(condition, a[i], b[i], span));
  return selected;
}

const Value& Operators::fixed(const Value& value, Span span) {
  if (value.traced()) {
    follow(equal(value, without_node(value)), span);
  } else if (const List* list = value.as_list()) {
    for (const Value& item : list->items) fixed(item, span);
  } else if (const Record* record = value.object<Record>()) {
    for (const Value& item : record->fields) fixed(item, span);
  }
  return value;
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

/// A text that only the execution of a solution knows; `span` is what makes it.
Value Operators::opaque_string(Span span) {
  Ref<String> text = make_ref<String>("?");
  text->opaque = span;
  return text;
}

void Operators::check_known(const Value& text) {
  const String* string = text.object<String>();
  if (string != nullptr && string->opaque) {
    unsupported(*string->opaque, "this text depends on choices, and the program looks at what it says",
                "look at the values that it is made of");
  }
}

}  // namespace solitaire
