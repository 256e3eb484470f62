#include <algorithm>
#include <fmt/format.h>

#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

/// How deep lists and records may nest in each other.
constexpr std::uint32_t kDeepestValue = 500;

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

}  // namespace

Value Evaluator::make_list(std::vector<Value> items, Span span) {
  Value list = Value::list(std::move(items));
  check_nesting(list, span);
  return list;
}

Value Evaluator::make_record(const RecordStmt* type, std::vector<Value> fields, Span span) {
  Value record = make_ref<Record>(type, std::move(fields));
  check_nesting(record, span);
  return record;
}

void Evaluator::check_nesting(const Value& value, Span span) {
  if (nesting(value) > kDeepestValue) {
    program_error(span, fmt::format("lists and records nest more than {} deep", kDeepestValue),
                  "to join lists, use xs + ys");
  }
}

Value Evaluator::with_items(const Value& value, const char* user, Span span,
                            const std::function<Value(const std::vector<Value>&)>& f) {
  return each_shape(value, [&](const Value& one) {
    if (one.as_list() == nullptr)
      program_error(span, fmt::format("'{}' needs a list, not {}", user, describe(one)));
    return f(one.as_list()->items);
  });
}

// ---- reading

Value Evaluator::element(const Value& object, const Value& index, Span span) {
  if (object.as_union() != nullptr || index.as_union() != nullptr) {
    return each_shape(object, [&](const Value& o) {
      return each_shape(index, [&](const Value& i) { return element(o, i, span); });
    });
  }
  if (object.as_list() == nullptr) program_error(span, fmt::format("{} has no elements", describe(object)));
  if (!index.has_type(Type::kInt))
    program_error(span, fmt::format("an index is an int, not {}", describe(index)));
  return element_of(object.as_list()->items, index, span);
}

Value Evaluator::element_of(const std::vector<Value>& items, const Value& index, Span span) {
  if (const auto* known = index.get<std::int64_t>()) {
    if (*known < 0 || *known >= static_cast<std::int64_t>(items.size())) reject(ConstraintKind::kIndex, span);
    return items[static_cast<std::size_t>(*known)];
  }
  const NodeId node = node_of(graph_, index);
  const auto [first, last] = possible_indices(node, items.size(), span);
  Value chosen = items[static_cast<std::size_t>(last)];
  for (std::int64_t i = last - 1; i >= first; --i) {
    chosen = merge(graph_, graph_.apply(Op::kEqInt, {node, graph_.constant(i)}),
                   items[static_cast<std::size_t>(i)], chosen);
  }
  return chosen;
}

/// The first and last index that a chosen index can take in a list of that length; others are ruled out.
std::pair<std::int64_t, std::int64_t> Evaluator::possible_indices(NodeId index, std::size_t count,
                                                                  Span span) {
  const Interval interval = graph_.node(index).interval;
  const auto end = static_cast<std::int64_t>(count) - 1;
  if (interval.hi < 0 || interval.lo > end) reject(ConstraintKind::kIndex, span);
  if (interval.lo < 0)
    require(graph_.apply(Op::kLeInt, {graph_.constant(std::int64_t{0}), index}), ConstraintKind::kIndex,
            span);
  if (interval.hi > end)
    require(graph_.apply(Op::kLeInt, {index, graph_.constant(end)}), ConstraintKind::kIndex, span);
  return {std::max<std::int64_t>(interval.lo, 0), std::min(interval.hi, end)};
}

Value Evaluator::field(const Value& object, const FieldExpr& access) {
  return each_shape(object, [&](const Value& one) -> Value {
    const Record* record = one.object<Record>();
    if (record == nullptr) program_error(access.field_span, fmt::format("{} has no fields", describe(one)));
    return record->fields[field_position(*record->type, access)];
  });
}

std::size_t Evaluator::field_position(const RecordStmt& type, const FieldExpr& access) {
  const auto at = std::find(type.numbers.begin(), type.numbers.end(), access.number);
  if (at == type.numbers.end()) {
    program_error(access.field_span, fmt::format("a record {} has no field '{}'", type.name, access.field),
                  field_help(type, access.field));
  }
  return static_cast<std::size_t>(at - type.numbers.begin());
}

void Evaluator::take_apart(const Value& value, std::size_t count, Span span,
                           const std::function<void(std::size_t, Value)>& give) {
  const Value parts = each_shape(value, [&](const Value& one) {
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
  for (std::size_t i = 0; i < count; ++i) give(i, parts.as_list()->items[i]);
}

// ---- writing

void Evaluator::assign(const Expr& target, Value value) {
  if (target.kind == ExprKind::kName) {
    current_->frame->slots[static_cast<const NameExpr&>(target).binding.slot] = std::move(value);
    return;
  }
  change(target, [&](Value& place) { place = value; });
}

/// Evaluates the target's indices, once, and changes what it stands for.
void Evaluator::change(const Expr& target, const Change& change) {
  std::vector<Value> indices;  // evaluated before anything changes, innermost last
  for (const Expr* at = &target; at->kind != ExprKind::kName;) {
    if (at->kind == ExprKind::kIndex) {
      const auto& index = static_cast<const IndexExpr&>(*at);
      indices.insert(indices.begin(), expression(*index.index));
      at = index.object.get();
    } else {
      at = static_cast<const FieldExpr&>(*at).object.get();
    }
  }
  update(target, indices, change);
}

/// Changes what the target stands for in place: the variable's value is only copied where others share it.
void Evaluator::update(const Expr& target, std::span<const Value> indices, const Change& change) {
  if (target.kind == ExprKind::kName) {
    const auto& name = static_cast<const NameExpr&>(target);
    Value& slot = current_->frame->slots[name.binding.slot];
    if (slot.is<Value::Unset>() || slot.as_union() != nullptr)
      slot = read(*current_->frame, name.binding.slot, name);
    return change(slot);
  }
  if (target.kind == ExprKind::kIndex) {
    return update(*static_cast<const IndexExpr&>(target).object, indices.first(indices.size() - 1),
                  [&](Value& object) { update_element(object, indices.back(), target.span, change); });
  }
  const auto& access = static_cast<const FieldExpr&>(target);
  update(*access.object, indices, [&](Value& object) { update_field(object, access, change); });
}

void Evaluator::update_element(Value& object, const Value& index, Span span, const Change& change) {
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
  if (object.as_list() == nullptr) program_error(span, fmt::format("{} has no elements", describe(object)));
  if (!index.has_type(Type::kInt))
    program_error(span, fmt::format("an index is an int, not {}", describe(index)));
  const std::size_t count = object.as_list()->items.size();
  if (const auto* known = index.get<std::int64_t>()) {
    if (*known < 0 || *known >= static_cast<std::int64_t>(count)) reject(ConstraintKind::kIndex, span);
    List& list = object.own<List>();
    Value& item = list.items[static_cast<std::size_t>(*known)];
    change(item);
    list.nesting = std::max(list.nesting, 1 + nesting(item));
  } else {
    const NodeId node = node_of(graph_, index);
    const auto [first, last] = possible_indices(node, count, span);
    List& list = object.own<List>();
    for (std::int64_t i = first; i <= last; ++i) {
      Value& item = list.items[static_cast<std::size_t>(i)];
      const NodeId here = graph_.apply(Op::kEqInt, {node, graph_.constant(i)});
      if (here == kFalse) continue;
      Value unchanged = item;
      Value none;
      const std::array guards = {here, graph_.negation(here)};
      split(guards, {}, none, [&](std::size_t side, Value& made) {
        made = unchanged;
        if (side == 0) change(made);
        return true;
      });
      item = std::move(none);
      list.nesting = std::max(list.nesting, 1 + nesting(item));
    }
  }
  check_nesting(object, span);
}

void Evaluator::update_field(Value& object, const FieldExpr& target, const Change& change) {
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
