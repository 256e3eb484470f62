#include "solitaire/run/structures.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "base/nearest_name.h"
#include "solitaire/value/chosen_list.h"

namespace solitaire {
namespace {

/// How many elements a..b may have as a value where its length depends on choices.
constexpr std::int64_t kLongestChosenRange = 4096;

/// Of more elements than this, a chosen one is found by halving. Judgement: both ways cost little up to here.
constexpr std::int64_t kMostInChain = 64;

std::string field_help(const RecordStmt& type, const std::string& name) {
  std::vector<std::string> names;
  std::string all;
  for (const Parameter& field : type.fields) {
    names.push_back(field.name);
    all += (all.empty() ? "" : ", ") + field.name;
  }
  const std::string nearest = nearest_name(name, names);
  return nearest.empty() ? fmt::format("it has {}", all) : fmt::format("did you mean '{}'?", nearest);
}

/// What to write for what is a method of lists elsewhere.
std::string method_help(const Value& object, const std::string& name) {
  if (!object.is_list()) return "";
  const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (is_one_of({"append", "push", "push_back", "add"})) return "to add an element, write xs = xs + [x]";
  if (is_one_of({"extend", "concat"})) return "to join lists, write xs = xs + ys";
  if (is_one_of({"length", "len", "size"})) return "write length(xs)";
  if (is_one_of({"contains", "includes", "has"})) return "write x in xs";
  return "lists have no methods: a function takes the list as an argument";
}

/// Returns true if these are two constant ints or more, each greater by 1 than the one before.
bool are_consecutive(std::span<const Value> items) {
  if (items.size() < 2) return false;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::int64_t* at = items[i].plain<std::int64_t>();
    if (at == nullptr || *at != *items[0].plain<std::int64_t>() + static_cast<std::int64_t>(i)) return false;
  }
  return true;
}

/// Returns true if these elements are numbers or bools of one type.
bool are_scalars(const Elements& list, std::pair<std::int64_t, std::int64_t> range) {
  for (const Type type : {Type::kInt, Type::kBool, Type::kFloat}) {
    if (!list.value(static_cast<std::size_t>(range.first)).has_type(type)) continue;
    for (std::int64_t i = range.first; i <= range.second; ++i) {
      if (!list.value(static_cast<std::size_t>(i)).has_type(type)) return false;
    }
    return true;
  }
  return false;
}

}  // namespace

Value Structures::make_record(const RecordStmt* type, std::vector<Value> fields, Span span) {
  Value record = make_ref<Record>(type, std::move(fields));
  check_nesting(record, span);
  return record;
}

void Structures::count_parts(const Value& value, Span span) {
  step(span);
  const auto count_all = [&](const std::vector<Value>& parts) {
    for (const Value& part : parts) count_parts(part, span);
  };
  if (const List* list = value.as_list()) count_all(list->items);
  if (const ChosenList* list = value.object<ChosenList>()) {
    for (const GuardedElement& element : list->elements) count_parts(element.value, span);
  }
  if (const Record* record = value.object<Record>()) count_all(record->fields);
  if (const Union* several = value.as_union()) count_largest(*several, span);
}

/// An execution has one of the alternatives, so that only one counts: that with most parts, as where paths
/// join.
void Structures::count_largest(const Union& several, Span span) {
  const std::uint64_t before = path_.steps;
  std::optional<std::uint64_t> joined;
  for (const Union::Alternative& one : several.alternatives) {
    path_.steps = before;
    count_parts(one.value, span);
    joined = joined ? joined_steps(*joined, path_.steps) : path_.steps;
  }
  path_.steps = joined.value_or(before);
}

void Structures::needs_list(const Value& value, const char* user, Span span) {
  program_error(span, fmt::format("'{}' needs a list, not {}", user, describe(value)));
}

// ---- ranges

Value Structures::up_to(const Value& first, const Value& last, Span span) {
  if (first.as_union() != nullptr || last.as_union() != nullptr) {
    return each_shape(first, [&](const Value& a) {
      return each_shape(last, [&](const Value& b) { return up_to(a, b, span); });
    });
  }
  if (!first.has_type(Type::kInt) || !last.has_type(Type::kInt)) {
    program_error(span,
                  fmt::format("'..' needs two ints, here are {} and {}", describe(first), describe(last)));
  }
  if (first.is<Symbol>() || last.is<Symbol>()) return chosen_range(first, last, span);
  const std::int64_t begin = *first.get<std::int64_t>();
  const std::int64_t end = *last.get<std::int64_t>();
  if (end >= begin) step(span, static_cast<std::uint64_t>(end - begin));
  if (first.traced() || last.traced()) {
    const Value length = int_operation(Op::kSub, last, first, span);
    follow(int_operation(Op::kEqInt, length, end - begin, span), span);
  }
  std::vector<Value> items;
  if (end >= begin) items.reserve(static_cast<std::size_t>(end - begin) + 1);
  for (std::int64_t i = begin; i <= end; ++i)
    items.push_back(int_operation(Op::kAdd, first, i - begin, span));
  return make_list(std::move(items), span);
}

/// a..b where its length depends on choices.
Value Structures::chosen_range(const Value& first, const Value& last, Span span) {
  const NodeId begin = node_of(*graph_, first);
  const NodeId length = apply(
      Op::kAdd, {apply(Op::kSub, {node_of(*graph_, last), begin}, span), graph_->constant(std::int64_t{1})},
      span);
  const Interval lengths = graph_->node(length).interval;
  const std::int64_t longest = std::max<std::int64_t>(lengths.hi, 0);
  if (longest > kLongestChosenRange) {
    unsupported(span, fmt::format("this range can have up to {} elements, depending on choices", longest),
                fmt::format("at most {} can be kept as a list; a for over the range itself has no such limit",
                            kLongestChosenRange));
  }
  std::vector<GuardedElement> elements;
  for (std::int64_t i = 0; i < longest; ++i) {
    const NodeId longer = graph_->apply(Op::kLtInt, {graph_->constant(i), length});
    elements.push_back({longer, arithmetic(BinaryOp::kAdd, first, i, span)});
  }
  return Value::chosen_list(std::move(elements), true);
}

// ---- reading

Value Structures::element(const Value& object, const Value& index, Span span) {
  if (object.as_union() != nullptr || !index.has_one_shape()) {
    return each_alternative(object, [&](const Value& o) {
      return each_shape(index, [&](const Value& i) { return element(o, i, span); });
    });
  }
  if (const List* several = index.as_list()) {
    std::vector<Value> items;
    for (const Value& one : several->items) items.push_back(element(object, one, span));
    step(span, items.size());
    return make_list(std::move(items), span);
  }
  check_indexed(object, index, span);
  if (object.is<ChosenList>()) return element_of_chosen(packed(*graph_, object), index, span);
  return element_of(object, index, span);
}

Value Structures::is_among(const Value& list, const Value& value, Span span) {
  if (list.is<List>() && value.has_type(Type::kInt) && are_consecutive(list.as_list()->items)) {
    const std::vector<Value>& items = list.as_list()->items;
    return both(compare(BinaryOp::kLessEqual, items.front(), value, span),
                compare(BinaryOp::kLessEqual, value, items.back(), span));
  }
  const Elements items(list);
  Value found = false;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto is_it = [&] { return equal(items.value(i), value, span); };
    found = either(found, where(has_element(items, i), span, is_it, false));
  }
  return found;
}

void Structures::check_indexed(const Value& object, const Value& index, Span span) {
  if (!object.is_list()) program_error(span, fmt::format("{} has no elements", describe(object)));
  if (!index.has_type(Type::kInt))
    program_error(span, fmt::format("an index is an int, not {}", describe(index)));
}

Value Structures::element_of(const Value& list, const Value& index, Span span) {
  const std::vector<Value>& items = list.as_list()->items;
  if (index.traced()) return traced_element(items, index, span);
  if (index.is<std::int64_t>()) return items[checked_index(index, items.size(), span)];
  return selected(Elements(list), node_of(*graph_, index), possible_indices(index, items.size(), span));
}

/// The scalar at one of the possible indices, as a balanced tree of comparisons of the index.
Value Structures::selected_scalar(const Elements& list, NodeId index,
                                  std::pair<std::int64_t, std::int64_t> possible) {
  const auto [first, last] = possible;
  if (first == last) return list.value(static_cast<std::size_t>(first));
  const std::int64_t middle = first + (last - first + 1) / 2;
  const Value low = selected_scalar(list, index, {first, middle - 1});
  const Value high = selected_scalar(list, index, {middle, last});
  if (low.identical(high)) return low;
  return merge(*graph_, graph_->apply(Op::kLtInt, {index, graph_->constant(middle)}), low, high);
}

/// The element at one of the possible indices. Of few elements each has a condition of its own, that the
/// index is its place, which solvers like best; of many these conditions would be long.
Value Structures::selected(const Elements& list, NodeId index,
                           std::pair<std::int64_t, std::int64_t> possible) {
  if (possible.second - possible.first >= kMostInChain && are_scalars(list, possible))
    return selected_scalar(list, index, possible);
  Value chosen = list.value(static_cast<std::size_t>(possible.second));
  for (std::int64_t i = possible.second - 1; i >= possible.first; --i) {
    chosen = merge(*graph_, graph_->apply(Op::kEqInt, {index, graph_->constant(i)}),
                   list.value(static_cast<std::size_t>(i)), chosen);
  }
  return chosen;
}

/// Of a packed list of chosen length.
Value Structures::element_of_chosen(const Value& list, const Value& index, Span span) {
  const Elements elements(list);
  const auto possible = require_index(elements, index, span);
  return selected(elements, node_of(*graph_, index), possible);
}

/// Rules out that a packed list of chosen length has no element at an index; returns the first and last index
/// that are left.
std::pair<std::int64_t, std::int64_t> Structures::require_index(const Elements& list, const Value& index,
                                                                Span span) {
  const auto possible = possible_indices(index, list.size(), span);
  Value inside = true;
  for (std::int64_t i = possible.first; i <= possible.second; ++i) {
    const Value has = has_element(list, static_cast<std::size_t>(i));
    inside = both(inside, either(has, invert(int_operation(Op::kEqInt, index, i, span))));
  }
  require(inside, ConstraintKind::kIndex, span);
  return possible;
}

/// The element that a known index that comes from choices selects. If all that it can select have one shape,
/// the node says which; else the execution is one of those in which the index is what it is.
Value Structures::traced_element(const std::vector<Value>& items, const Value& index, Span span) {
  const std::int64_t known = *index.get<std::int64_t>();
  const auto [first, last] = possible_indices(index, items.size(), span);
  const auto begin = items.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = items.begin() + static_cast<std::ptrdiff_t>(last) + 1;
  if (!std::all_of(begin, end,
                   [&](const Value& item) { return same(*begin, item) || same_shape(*begin, item); })) {
    follow(int_operation(Op::kEqInt, index, known, span), span);
    return items[static_cast<std::size_t>(known)];
  }
  Value chosen = items[static_cast<std::size_t>(last)];
  for (std::int64_t i = last - 1; i >= first; --i) {
    chosen =
        select(int_operation(Op::kEqInt, index, i, span), items[static_cast<std::size_t>(i)], chosen, span);
  }
  return chosen;
}

std::size_t Structures::checked_index(const Value& index, std::size_t count, Span span) {
  const std::int64_t known = *index.get<std::int64_t>();
  if (known < 0 || known >= static_cast<std::int64_t>(count)) reject(ConstraintKind::kIndex, span);
  return static_cast<std::size_t>(known);
}

/// The first and last index that a chosen index can take in a list of that length, of which there is at least
/// one; others are ruled out.
std::pair<std::int64_t, std::int64_t> Structures::possible_indices(const Value& index, std::size_t count,
                                                                   Span span) {
  const Interval interval = graph_->node(node_of(*graph_, index)).interval;
  const auto end = static_cast<std::int64_t>(count) - 1;
  if (count == 0 || interval.hi < 0 || interval.lo > end) reject(ConstraintKind::kIndex, span);
  if (interval.lo < 0)
    require(int_operation(Op::kLeInt, std::int64_t{0}, index, span), ConstraintKind::kIndex, span);
  if (interval.hi > end) require(int_operation(Op::kLeInt, index, end, span), ConstraintKind::kIndex, span);
  return {std::max<std::int64_t>(interval.lo, 0), std::min(interval.hi, end)};
}

Value Structures::field(const Value& object, const FieldExpr& access) {
  return each_shape(object, [&](const Value& one) -> Value {
    const Record* record = one.object<Record>();
    if (record == nullptr) {
      program_error(access.field_span, fmt::format("{} has no fields", describe(one)),
                    method_help(one, access.field));
    }
    return record->fields[field_position(*record->type, access)];
  });
}

void Structures::no_such_field(const RecordStmt& type, const FieldExpr& access) {
  program_error(access.field_span, fmt::format("a record {} has no field '{}'", type.name, access.field),
                field_help(type, access.field));
}

/// The value, on the paths on which it is a list of that length.
Value Structures::checked_parts(const Value& value, std::size_t count, Span span) {
  return each_shape(value, [&](const Value& one) {
    const List* list = one.as_list();
    if (list == nullptr) {
      program_error(span, fmt::format("{} cannot be taken apart into {} variables", describe(one), count));
    }
    if (list->items.size() != count) {
      program_error(span, fmt::format("a list of {} cannot be taken apart into {} variables",
                                      list->items.size(), count));
    }
    return one;
  });
}

// ---- changing

void Structures::append(Value& collected, const Value& element, Span span) {
  if (collected.is_list()) return append_one(collected, {kTrue, element}, span);
  collected = each_alternative(collected, [&](const Value& list) {
    Value longer = list;
    append_one(longer, {kTrue, element}, span);
    return longer;
  });
}

/// In place, if nothing shares the list. A list of known length takes elements alone that it always has.
void Structures::append_one(Value& collected, const GuardedElement& element, Span span) {
  const auto add = [&](auto& list, auto& elements, const auto& added) {
    elements.push_back(added);
    list.nesting = std::max(list.nesting, 1 + nesting(element.value));
  };
  if (collected.is<List>()) {
    List& list = collected.own<List>();
    add(list, list.items, element.value);
  } else {
    ChosenList& list = collected.own<ChosenList>();
    add(list, list.elements, element);
    list.packed = false;
  }
  check_nesting(collected, span);
}

void Structures::append_all(Value& collected, const Value& more, Span span) {
  if (!collected.is_list() || !more.is_list()) {
    collected = arithmetic(BinaryOp::kAdd, collected, more, span);
    return;
  }
  const Elements added(more);
  if (more.is<ChosenList>() && collected.is<List>()) {
    collected = concatenate_lists(collected, more);
    check_nesting(collected, span);
  } else {
    for (std::size_t i = 0; i < added.size(); ++i)
      append_one(collected, {added.guard(i), added.value(i)}, span);
  }
}

void Structures::update_element(Value& object, const Value& index, Span span, const Change& change) {
  if (object.as_union() != nullptr || !index.has_one_shape()) {
    object = each_alternative(object, [&](const Value& one) {
      return each_shape(index, [&](const Value& i) {
        Value changed = one;
        update_element(changed, i, span, change);
        return changed;
      });
    });
    return;
  }
  check_indexed(object, index, span);
  // Once its elements are in their places, the length may turn out to be known.
  if (object.is<ChosenList>()) object = packed(*graph_, object);
  if (object.is<ChosenList>()) return update_chosen_list(object, index, span, change);
  const std::size_t count = object.as_list()->items.size();
  if (index.is<std::int64_t>()) {
    if (index.traced()) follow(int_operation(Op::kEqInt, index, *index.get<std::int64_t>(), span), span);
    const std::size_t at = checked_index(index, count, span);
    List& list = object.own<List>();
    change(list.items[at]);
    list.nesting = std::max(list.nesting, 1 + nesting(list.items[at]));
  } else {
    const auto [first, last] = possible_indices(index, count, span);
    List& list = object.own<List>();
    for (std::int64_t i = first; i <= last; ++i) {
      Value& item = list.items[static_cast<std::size_t>(i)];
      update_where(item, graph_->apply(Op::kEqInt, {node_of(*graph_, index), graph_->constant(i)}), change);
      list.nesting = std::max(list.nesting, 1 + nesting(item));
    }
  }
  check_nesting(object, span);
}

void Structures::update_chosen_list(Value& object, const Value& index, Span span, const Change& change) {
  const auto [first, last] = require_index(Elements(object), index, span);
  ChosenList& list = object.own<ChosenList>();
  for (std::int64_t i = first; i <= last; ++i) {
    Value& item = list.elements[static_cast<std::size_t>(i)].value;
    update_where(item, graph_->apply(Op::kEqInt, {node_of(*graph_, index), graph_->constant(i)}), change);
    list.nesting = std::max(list.nesting, 1 + nesting(item));
  }
  check_nesting(object, span);
}

/// Changes an item where a condition holds.
void Structures::update_where(Value& item, NodeId here, const Change& change) {
  if (here == kFalse) return;
  if (here == kTrue) return change(item);
  const Value unchanged = item;
  Value changed;
  const std::array guards = {here, graph_->negation(here)};
  split(guards, {}, changed, [&](std::size_t side, Value& made) {
    made = unchanged;
    if (side == 0) change(made);
    return true;
  });
  item = std::move(changed);
}

void Structures::update_field(Value& object, const FieldExpr& target, const Change& change) {
  if (!object.has_one_shape()) {
    object = each_shape(object, [&](const Value& one) {
      Value changed = one;
      update_field(changed, target, change);
      return changed;
    });
    return;
  }
  if (object.object<Record>() == nullptr)
    program_error(target.field_span, fmt::format("{} has no fields", describe(object)));
  Record& record = object.own<Record>();
  Value& field = record.fields[field_position(*record.type, target)];
  change(field);
  record.nesting = std::max(record.nesting, 1 + nesting(field));
  check_nesting(object, target.span);
}

}  // namespace solitaire
