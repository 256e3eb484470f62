#include "solitaire/value/merge.h"

#include <algorithm>
#include <utility>

#include "solitaire/value/elements.h"

namespace solitaire {

bool same_shape(const Value& a, const Value& b) {
  for (const Type type : {Type::kBool, Type::kInt, Type::kFloat}) {
    if (a.has_type(type)) return b.has_type(type);
  }
  if (a.kind() != b.kind()) return false;
  if (const List* list = a.as_list()) return list->items.size() == b.as_list()->items.size();
  if (const Record* record = a.object<Record>()) return record->type == b.object<Record>()->type;
  if (const Joined* joined = a.object<Joined>())
    return joined->parts.size() == b.object<Joined>()->parts.size();
  return same(a, b);  // strings, functions: what is not the same differs in shape
}

namespace {

std::vector<Value> merge_members(Graph& graph, NodeId condition, const std::vector<Value>& a,
                                 const std::vector<Value>& b) {
  std::vector<Value> merged;
  merged.reserve(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) merged.push_back(merge(graph, condition, a[i], b[i]));
  return merged;
}

/// Returns true if two that are no unions merge into one value that is none either.
bool can_merge(const Value& a, const Value& b) { return (a.is_list() && b.is_list()) || same_shape(a, b); }

/// Where two lists have the same elements under the same guards: so many from the start, so many at the end.
struct Common {
  std::size_t first, last;
};

Common common_ends(const Elements& a, const Elements& b) {
  const std::size_t most = std::min(a.size(), b.size());
  const auto alike = [&](std::size_t i, std::size_t j) {
    return a.guard(i) == b.guard(j) && same(a.value(i), b.value(j));
  };
  Common common{0, 0};
  while (common.first < most && alike(common.first, common.first)) ++common.first;
  while (common.first + common.last < most && a.size() != b.size() &&
         alike(a.size() - common.last - 1, b.size() - common.last - 1))
    ++common.last;
  return common;
}

/// Lists of which one at least has a chosen length, or of different lengths: what lies between common ends is
/// merged from its start.
Value merge_lists(Graph& graph, NodeId condition, const Value& a, const Value& b) {
  const Elements x(a), y(b);
  const auto [first, last] = common_ends(x, y);
  const NodeId otherwise = graph.negation(condition);
  std::vector<GuardedElement> merged;
  merged.reserve(std::max(x.size(), y.size()));
  for (std::size_t i = 0; i < first; ++i) merged.push_back({x.guard(i), x.value(i)});
  const std::size_t end_of_x = x.size() - last, end_of_y = y.size() - last;
  for (std::size_t i = first; i < std::max(end_of_x, end_of_y); ++i) {
    if (i >= end_of_y) {
      merged.push_back({graph.conjunction(condition, x.guard(i)), x.value(i)});
    } else if (i >= end_of_x) {
      merged.push_back({graph.conjunction(otherwise, y.guard(i)), y.value(i)});
    } else {
      merged.push_back(
          {graph.phi(condition, x.guard(i), y.guard(i)), merge(graph, condition, x.value(i), y.value(i))});
    }
  }
  for (std::size_t i = end_of_x; i < x.size(); ++i) merged.push_back({x.guard(i), x.value(i)});
  return Value::chosen_list(std::move(merged), x.packed() && y.packed() && last == 0);
}

/// Assumes: can_merge(a, b).
Value merge_shaped(Graph& graph, NodeId condition, const Value& a, const Value& b) {
  if (same(a, b)) return a;
  if (a.is_list() && !same_shape(a, b)) return merge_lists(graph, condition, a, b);
  if (const List* list = a.as_list()) {
    return Value::list(merge_members(graph, condition, list->items, b.as_list()->items));
  }
  if (const Record* record = a.object<Record>()) {
    return make_ref<Record>(record->type,
                            merge_members(graph, condition, record->fields, b.object<Record>()->fields));
  }
  if (const Joined* joined = a.object<Joined>()) {
    return make_ref<Joined>(merge_members(graph, condition, joined->parts, b.object<Joined>()->parts),
                            joined->span);
  }
  return value_of(graph, graph.phi(condition, node_of(graph, a), node_of(graph, b)));
}

using Alternative = Union::Alternative;

std::vector<Alternative> alternatives_of(const Value& value) {
  if (const Union* several = value.as_union()) return several->alternatives;
  return {{kTrue, value}};
}

/// Within one value the shapes differ already, so an alternative of `b` meets at most one of `a`.
Value merge_alternatives(Graph& graph, NodeId condition, const Value& a, const Value& b) {
  std::vector<Alternative> merged = alternatives_of(a);
  const std::size_t of_a = merged.size();
  const NodeId otherwise = graph.negation(condition);
  std::vector<bool> met(of_a, false);
  for (const Alternative& other : alternatives_of(b)) {
    std::size_t i = 0;
    while (i < of_a && (met[i] || !can_merge(merged[i].value, other.value))) ++i;
    if (i < of_a) {
      met[i] = true;
      merged[i].value = merge_shaped(graph, condition, merged[i].value, other.value);
      merged[i].guard = graph.phi(condition, merged[i].guard, other.guard);
    } else {
      merged.push_back({graph.conjunction(otherwise, other.guard), other.value});
    }
  }
  for (std::size_t i = 0; i < of_a; ++i) {
    if (!met[i]) merged[i].guard = graph.conjunction(condition, merged[i].guard);
  }
  std::erase_if(merged, [](const Alternative& alternative) { return alternative.guard == kFalse; });
  if (merged.size() == 1) return merged.front().value;
  return make_ref<Union>(std::move(merged));
}

}  // namespace

Value merge(Graph& graph, NodeId condition, const Value& a, const Value& b) {
  if (condition == kTrue) return a;
  if (condition == kFalse) return b;
  if (a.identical(b)) return a;
  if (!a.as_union() && !b.as_union() && can_merge(a, b)) return merge_shaped(graph, condition, a, b);
  return merge_alternatives(graph, condition, a, b);
}

NodeId node_of(Graph& graph, const Value& value) {
  if (const Symbol* symbol = value.get<Symbol>()) return symbol->node;
  if (value.traced()) return value.node();
  if (const bool* b = value.get<bool>()) return graph.constant(*b);
  if (const std::int64_t* i = value.get<std::int64_t>()) return graph.constant(*i);
  return graph.constant(*value.get<double>());
}

Value value_of(const Graph& graph, NodeId id) {
  const Graph::Node& node = graph.node(id);
  if (!node.is_constant()) return Symbol{id, node.type()};
  const Scalar scalar = graph.scalar(id);
  switch (node.type()) {
    case Type::kBool:
      return scalar.i != 0;
    case Type::kInt:
      return scalar.i;
    case Type::kFloat:
      return scalar.f;
  }
  return {};
}

}  // namespace solitaire
