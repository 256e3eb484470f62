#include "solitaire/builtins/list_functions.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

using Call = const BuiltinCall&;
using Items = std::span<const Value>;

/// How many elements of a list equal a value.
Value count_in(Evaluator& evaluator, const Value& list, const Value& wanted, Span span) {
  const Elements items(list);
  Value total = std::int64_t{0};
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto is_one = [&] { return evaluator.equal(items.value(i), wanted, span); };
    const Value counts = evaluator.where(evaluator.has_element(items, i), span, is_one, false);
    const Value one = evaluator.select(counts, std::int64_t{1}, std::int64_t{0}, span);
    total = evaluator.arithmetic(BinaryOp::kAdd, total, one, span);
  }
  return total;
}

/// Requires that the list has an element.
void require_element(Evaluator& evaluator, const Elements& items, ConstraintKind kind, Span span) {
  if (items.size() == 0) evaluator.reject(kind, span);
  evaluator.require(evaluator.has_any_element(items), kind, span);
}

/// The first element that the list has, or the last one. It has one at least.
Value outermost(Evaluator& evaluator, const Elements& items, bool last, Span span) {
  const auto position = [&](std::size_t number) { return last ? items.size() - 1 - number : number; };
  std::size_t certain = 0;  // counted from that end, which of them is always there
  while (certain + 1 < items.size() && items.guard(position(certain)) != kTrue) ++certain;
  Value found = items.value(position(certain));
  for (std::size_t i = certain; i-- > 0;) {
    const Value has = evaluator.has_element(items, position(i));
    found = evaluator.select(has, items.value(position(i)), found, span);
  }
  return found;
}

Value required_element(Evaluator& evaluator, Call call, const char* name, bool last) {
  return evaluator.with_list(call.arguments[0], name, call.site.span, [&](const Value& list) {
    const Elements items(list);
    require_element(evaluator, items, ConstraintKind::kIndex, call.site.span);
    return outermost(evaluator, items, last, call.site.span);
  });
}

/// For each element of a list, whether it is there and equals the value, as a bool.
std::vector<Value> equalities(Evaluator& evaluator, const Elements& items, const Value& value, Span span) {
  std::vector<Value> equal;
  equal.reserve(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto is_equal = [&] { return evaluator.equal(items.value(i), value, span); };
    equal.push_back(evaluator.where(evaluator.has_element(items, i), span, is_equal, false));
  }
  return equal;
}

/// What a function makes of each item.
std::vector<Value> keys_of(Evaluator& evaluator, const Value& function, Items items, Call call) {
  const Value list = Value::list({items.begin(), items.end()});
  const Value keys = evaluator.map_list(function, list, call.site);
  return keys.as_list()->items;
}

}  // namespace

Value count_equal(Evaluator& evaluator, Call call) {
  const Value wanted = given(call.arguments[1]) ? call.arguments[1] : Value(true);
  return evaluator.with_list(call.arguments[0], "count", call.site.span, [&](const Value& list) {
    return count_in(evaluator, list, wanted, call.site.span);
  });
}

Value index_of(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.with_list(call.arguments[0], "index_of", span, [&](const Value& given_list) -> Value {
    const Value list = evaluator.in_place(given_list);
    const std::vector<Value> equal = equalities(evaluator, Elements(list), call.arguments[1], span);
    Value found = false;
    for (const Value& one : equal) found = evaluator.either(found, one);
    if (const bool* known = found.plain<bool>(); known != nullptr && !*known)
      evaluator.reject(ConstraintKind::kIndex, span);
    evaluator.require(found, ConstraintKind::kIndex, span);
    Value index = static_cast<std::int64_t>(equal.size()) - 1;
    for (std::size_t i = equal.size() - 1; i-- > 0;)
      index = evaluator.select(equal[i], static_cast<std::int64_t>(i), index, span);
    return index;
  });
}

Value first_element(Evaluator& evaluator, Call call) {
  return required_element(evaluator, call, "first", false);
}

Value last_element(Evaluator& evaluator, Call call) {
  return required_element(evaluator, call, "last", true);
}

Value enumerate(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.with_list(call.arguments[0], "enumerate", span, [&](const Value& given_list) {
    const Value list = evaluator.in_place(given_list);
    const Elements items(list);
    evaluator.step(span, items.size());
    std::vector<GuardedElement> made;
    for (std::size_t i = 0; i < items.size(); ++i)
      made.push_back(
          {items.guard(i), evaluator.make_list({static_cast<std::int64_t>(i), items.value(i)}, span)});
    return Value::chosen_list(std::move(made), true);
  });
}

/// Many languages have the list first.
void check_order(Evaluator& evaluator, Call call, const char* name) {
  if (!call.arguments[1].is_function()) return;
  evaluator.program_error(call.site.span, fmt::format("'{}' takes the function first, then the list", name),
                          fmt::format("write {}(f, xs), or a comprehension: [f(x) for x in xs]", name));
}

Value map_function(Evaluator& evaluator, Call call) {
  check_order(evaluator, call, "map");
  return evaluator.map_list(call.arguments[0], call.arguments[1], call.site);
}

Value filter_function(Evaluator& evaluator, Call call) {
  check_order(evaluator, call, "filter");
  return evaluator.filter_list(call.arguments[0], call.arguments[1], call.site);
}

// ---- order

namespace {

/// Returns true if all keys are constants of which it is known how they compare.
bool are_constants(Items keys) {
  return std::all_of(keys.begin(), keys.end(), [](const Value& key) {
    return key.plain<std::int64_t>() != nullptr || key.plain<double>() != nullptr;
  });
}

std::vector<Value> sorted_constants(Evaluator& evaluator, Items items, Items keys, Span span) {
  std::vector<std::size_t> order(items.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return *evaluator.compare(BinaryOp::kLess, keys[a], keys[b], span).get<bool>();
  });
  std::vector<Value> sorted;
  for (const std::size_t i : order) sorted.push_back(items[i]);
  return sorted;
}

/// Sorts by comparing neighbours in an order that does not depend on what they are: insertion sort as a
/// network, which keeps equal ones in their order (Knuth, The Art of Computer Programming 3, section 5.3.4).
std::vector<Value> sorted_by_network(Evaluator& evaluator, Items given_items, Items given_keys, Span span) {
  std::vector<Value> items(given_items.begin(), given_items.end());
  std::vector<Value> keys(given_keys.begin(), given_keys.end());
  evaluator.step(span, items.size() * items.size() / 2);
  const auto exchange = [&](const Value& less, std::vector<Value>& values, std::size_t at) {
    const Value before = evaluator.select(less, values[at + 1], values[at], span);
    values[at + 1] = evaluator.select(less, values[at], values[at + 1], span);
    values[at] = before;
  };
  for (std::size_t end = 1; end < items.size(); ++end) {
    for (std::size_t at = end; at-- > 0;) {
      const Value less = evaluator.compare(BinaryOp::kLess, keys[at + 1], keys[at], span);
      if (const bool* known = less.plain<bool>(); known != nullptr && !*known) continue;
      exchange(less, items, at);
      exchange(less, keys, at);
    }
  }
  return items;
}

void check_numbers(Evaluator& evaluator, Items keys, const char* name, Span span) {
  for (const Value& key : keys) {
    evaluator.each_shape(key, [&](const Value& one) {
      if (!one.is_number())
        evaluator.program_error(span, fmt::format("'{}' needs numbers, here is {}", name, describe(one)),
                                "key: fun(x) { ... } gives a number for each");
      return one;
    });
  }
}

/// The first of the items whose key is least, or greatest.
Value extreme_by(Evaluator& evaluator, Items items, Items keys, BinaryOp better, Span span) {
  Value best = items.front();
  Value best_key = keys.front();
  for (std::size_t i = 1; i < items.size(); ++i) {
    const Value takes = evaluator.compare(better, keys[i], best_key, span);
    best = evaluator.select(takes, items[i], best, span);
    best_key = evaluator.select(takes, keys[i], best_key, span);
  }
  return best;
}

/// The function that is given as `key:`, or null. Named arguments of other names are errors.
const Value* key_function(Evaluator& evaluator, Call call, const char* name) {
  for (const auto& [parameter, value] : call.extras) {
    if (parameter == "key") return &value;
    evaluator.program_error(call.site.span, fmt::format("'{}' has no parameter '{}'", name, parameter));
  }
  return nullptr;
}

/// The least of the elements, or the greatest.
Value extreme_of(Evaluator& evaluator, const Elements& items, Op op, Span span) {
  require_element(evaluator, items, ConstraintKind::kNotEmpty, span);
  const auto checked = [&](std::size_t i) {  // an error where it is no number
    const auto itself = [&] { return evaluator.pick(op, items.value(i), items.value(i), span); };
    return evaluator.where(evaluator.has_element(items, i), span, itself, items.value(i));
  };
  Value best = checked(0);
  Value any = evaluator.has_element(items, 0);  // whether there is one so far
  for (std::size_t i = 1; i < items.size(); ++i) {
    const Value has = evaluator.has_element(items, i);
    const Value both = evaluator.both(any, has);
    const Value item = both.is<bool>() ? items.value(i) : checked(i);  // which pick() checks otherwise
    const auto better = [&] { return evaluator.pick(op, best, item, span); };
    best = evaluator.select(has, evaluator.where(both, span, better, item), best, span);
    any = evaluator.either(any, has);
  }
  return best;
}

Value extreme(Evaluator& evaluator, Call call, Op op) {
  const Span span = call.site.span;
  const char* name = operation(op).name.data();
  const Value* key = key_function(evaluator, call, name);
  const Value given_list = call.arguments.size() > 1
                               ? Value::list({call.arguments.begin(), call.arguments.end()})
                               : call.arguments[0];
  if (key == nullptr) {
    return evaluator.with_list(given_list, name, span, [&](const Value& list) {
      return extreme_of(evaluator, Elements(list), op, span);
    });
  }
  return evaluator.with_items(given_list, name, span, [&](Items items) -> Value {
    if (items.empty()) evaluator.reject(ConstraintKind::kNotEmpty, span);
    const std::vector<Value> keys = keys_of(evaluator, *key, items, call);
    check_numbers(evaluator, keys, name, span);
    return extreme_by(evaluator, items, keys, op == Op::kMin ? BinaryOp::kLess : BinaryOp::kGreater, span);
  });
}

}  // namespace

Value minimum(Evaluator& evaluator, Call call) { return extreme(evaluator, call, Op::kMin); }
Value maximum(Evaluator& evaluator, Call call) { return extreme(evaluator, call, Op::kMax); }

Value sort(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.with_items(call.arguments[0], "sort", span, [&](Items items) {
    std::vector<Value> keys(items.begin(), items.end());
    if (given(call.arguments[1])) keys = keys_of(evaluator, call.arguments[1], items, call);
    check_numbers(evaluator, keys, "sort", span);
    std::vector<Value> sorted = are_constants(keys) ? sorted_constants(evaluator, items, keys, span)
                                                    : sorted_by_network(evaluator, items, keys, span);
    return evaluator.make_list(std::move(sorted), span);
  });
}

}  // namespace solitaire
