#include "solitaire/value/merge.h"

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

/// Assumes: same_shape(a, b).
Value merge_shaped(Graph& graph, NodeId condition, const Value& a, const Value& b) {
  if (same(a, b)) return a;
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
    while (i < of_a && (met[i] || !same_shape(merged[i].value, other.value))) ++i;
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
  if (!a.as_union() && !b.as_union() && same_shape(a, b)) return merge_shaped(graph, condition, a, b);
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
