#include "solitaire/run/comparisons.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "solitaire/run/binary_meaning.h"
#include "solitaire/value/elements.h"
#include "solitaire/value/joined.h"

namespace solitaire {
namespace {

/// Returns true if two values that are not both numbers or both bools are of one kind.
bool are_alike(const Value& a, const Value& b) {
  if (a.is<Symbol>() || b.is<Symbol>()) return false;
  return a.kind() == b.kind() || (is_one_string(a) && is_one_string(b)) ||
         (a.is_function() && b.is_function());
}

/// Returns the int of the language that is the same number, if there is one.
std::optional<std::int64_t> int_of(double number) {
  constexpr double kPastAll = 0x1p62;
  if (!(std::abs(number) < kPastAll) || number != std::floor(number)) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

}  // namespace

Value Comparisons::compare(BinaryOp op, const Value& a, const Value& b, Span span) {
  if (a.as_union() != nullptr || b.as_union() != nullptr) {
    return each_shape(a, b, [&](const Value& x, const Value& y) { return compare(op, x, y, span); });
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

Value Comparisons::int_below(const Value& a, double b, bool strict, Span span) {
  const std::optional<std::int64_t> end = int_of(strict ? std::ceil(b) : std::floor(b));
  return end ? int_operation(strict ? Op::kLtInt : Op::kLeInt, a, *end, span) : Value(b > 0);
}

Value Comparisons::int_above(const Value& a, double b, bool strict, Span span) {
  const std::optional<std::int64_t> end = int_of(strict ? std::floor(b) : std::ceil(b));
  return end ? int_operation(strict ? Op::kLtInt : Op::kLeInt, *end, a, span) : Value(b < 0);
}

Value Comparisons::equal(const Value& a, const Value& b, Span span) {
  if ((has_parts(a) || has_parts(b)) && is_text(a) && is_text(b)) return equal_texts(a, b);
  if (a.as_union() == nullptr && b.as_union() == nullptr) return equal_shaped(a, b, span);
  return each_shape(a, b, [&](const Value& x, const Value& y) { return equal_shaped(x, y, span); });
}

/// Two strings of parts are compared part by part if these have the same sizes; else one is written out.
Value Comparisons::equal_texts(const Value& a, const Value& b) {
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

Value Comparisons::equal_shaped(const Value& a, const Value& b, Span span) {
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
  if (a.is_list() && b.is_list()) return equal_lists(in_place(a), in_place(b), span);
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

Value Comparisons::int_equals(const Value& a, double b) {
  const std::optional<std::int64_t> same = int_of(b);
  return same ? int_operation(Op::kEqInt, a, *same, {}) : Value(false);
}

Value Comparisons::equal_members(const std::vector<Value>& a, const std::vector<Value>& b, Span span) {
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
Value Comparisons::equal_lists(const Value& a, const Value& b, Span span) {
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

Value Comparisons::opaque_string(Span span) {
  Ref<String> text = make_ref<String>("?");
  text->opaque = span;
  return text;
}

void Comparisons::check_known(const Value& text) {
  const String* string = text.object<String>();
  if (string != nullptr && string->opaque) {
    unsupported(*string->opaque, "this text depends on choices, and the program looks at what it says",
                "look at the values that it is made of");
  }
}

}  // namespace solitaire
