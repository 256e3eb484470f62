#include "solitaire/run/structures.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "base/nearest_name.h"

namespace solitaire {
namespace {

/// How many elements a..b may have as a value where its length depends on choices.
constexpr std::int64_t kLongestChosenRange = 4096;

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
  if (object.as_list() == nullptr) return "";
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

/// a..b where its length depends on choices: a list of each length that it can have.
Value Structures::chosen_range(const Value& first, const Value& last, Span span) {
  const NodeId begin = node_of(*graph_, first);
  const NodeId length = apply(
      Op::kAdd, {apply(Op::kSub, {node_of(*graph_, last), begin}, span), graph_->constant(std::int64_t{1})},
      span);
  const Interval lengths = graph_->node(length).interval;
  const std::int64_t longest = std::max<std::int64_t>(lengths.hi, 0);
  const std::int64_t shortest = std::max<std::int64_t>(lengths.lo, 0);
  if (longest > kLongestChosenRange) {
    unsupported(span, fmt::format("this range can have up to {} elements, depending on choices", longest),
                fmt::format("at most {} can be kept as a list; a for over the range itself has no such limit",
                            kLongestChosenRange));
  }
  Value result;
  std::vector<Value> items;
  for (std::int64_t i = 0; i < longest; ++i) items.push_back(arithmetic(BinaryOp::kAdd, first, i, span));
  result = make_list(items, span);
  for (std::int64_t count = longest - 1; count >= shortest; --count) {
    items.pop_back();
    result = merge(*graph_, graph_->apply(Op::kLeInt, {length, graph_->constant(count)}),
                   make_list(items, span), result);
  }
  return result;
}

// ---- reading

Value Structures::element(const Value& object, const Value& index, Span span) {
  if (object.as_union() != nullptr || index.as_union() != nullptr) {
    return each_shape(object, [&](const Value& o) {
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
  return element_of(object.as_list()->items, index, span);
}

Value Structures::is_among(std::span<const Value> items, const Value& value, Span span) {
  if (value.has_type(Type::kInt) && are_consecutive(items)) {
    return both(compare(BinaryOp::kLessEqual, items.front(), value, span),
                compare(BinaryOp::kLessEqual, value, items.back(), span));
  }
  Value found = false;
  for (const Value& item : items) found = either(found, equal(item, value, span));
  return found;
}

void Structures::check_indexed(const Value& object, const Value& index, Span span) {
  if (object.as_list() == nullptr) program_error(span, fmt::format("{} has no elements", describe(object)));
  if (!index.has_type(Type::kInt))
    program_error(span, fmt::format("an index is an int, not {}", describe(index)));
}

Value Structures::element_of(const std::vector<Value>& items, const Value& index, Span span) {
  if (index.traced()) return traced_element(items, index, span);
  if (index.is<std::int64_t>()) return items[checked_index(index, items.size(), span)];
  const auto [first, last] = possible_indices(index, items.size(), span);
  const NodeId node = node_of(*graph_, index);
  Value chosen = items[static_cast<std::size_t>(last)];
  for (std::int64_t i = last - 1; i >= first; --i) {
    chosen = merge(*graph_, graph_->apply(Op::kEqInt, {node, graph_->constant(i)}),
                   items[static_cast<std::size_t>(i)], chosen);
  }
  return chosen;
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

/// The first and last index that a chosen index can take in a list of that length; others are ruled out.
std::pair<std::int64_t, std::int64_t> Structures::possible_indices(const Value& index, std::size_t count,
                                                                   Span span) {
  const Interval interval = graph_->node(node_of(*graph_, index)).interval;
  const auto end = static_cast<std::int64_t>(count) - 1;
  if (interval.hi < 0 || interval.lo > end) reject(ConstraintKind::kIndex, span);
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
  if (collected.is<List>() && collected.unique()) {
    List& list = collected.own<List>();
    list.items.push_back(element);
    list.nesting = std::max(list.nesting, 1 + nesting(element));
    return check_nesting(collected, span);
  }
  collected = each_shape(collected, [&](const Value& list) {
    std::vector<Value> items = list.as_list()->items;
    items.push_back(element);
    return make_list(std::move(items), span);
  });
}

void Structures::update_element(Value& object, const Value& index, Span span, const Change& change) {
  if (object.as_union() != nullptr || index.as_union() != nullptr) {
    object = each_shape(object, [&](const Value& one) {
      return each_shape(index, [&](const Value& i) {
        Value changed = one;
        update_element(changed, i, span, change);
        return changed;
      });
    });
    return;
  }
  check_indexed(object, index, span);
  const std::size_t count = object.as_list()->items.size();
  if (index.is<std::int64_t>()) {
    if (index.traced()) follow(int_operation(Op::kEqInt, index, *index.get<std::int64_t>(), span), span);
    const std::size_t at = checked_index(index, count, span);
    List& list = object.own<List>();
    change(list.items[at]);
    list.nesting = std::max(list.nesting, 1 + nesting(list.items[at]));
  } else {
    const auto possible = possible_indices(index, count, span);
    update_chosen(object.own<List>(), node_of(*graph_, index), possible, change);
  }
  check_nesting(object, span);
}

/// Changes each element that the index can select, where it selects it.
void Structures::update_chosen(List& list, NodeId index, std::pair<std::int64_t, std::int64_t> possible,
                               const Change& change) {
  for (std::int64_t i = possible.first; i <= possible.second; ++i) {
    Value& item = list.items[static_cast<std::size_t>(i)];
    const NodeId here = graph_->apply(Op::kEqInt, {index, graph_->constant(i)});
    if (here == kFalse) continue;
    Value unchanged = item;
    Value none;
    const std::array guards = {here, graph_->negation(here)};
    split(guards, {}, none, [&](std::size_t side, Value& made) {
      made = unchanged;
      if (side == 0) change(made);
      return true;
    });
    item = std::move(none);
    list.nesting = std::max(list.nesting, 1 + nesting(item));
  }
}

void Structures::update_field(Value& object, const FieldExpr& target, const Change& change) {
  if (object.as_union() != nullptr) {
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
