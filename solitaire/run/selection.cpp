#include "solitaire/run/selection.h"

#include <vector>

namespace solitaire {
namespace {

bool is_scalar(const Value& value) { return value.has_type(Type::kBool) || value.is_number(); }

Value without_node(const Value& value) {
  if (const bool* b = value.get<bool>()) return *b;
  if (const std::int64_t* i = value.get<std::int64_t>()) return *i;
  return *value.get<double>();
}

}  // namespace

Value Selection::select_open(const Value& condition, const Value& a, const Value& b, Span span) {
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

std::vector<Value> Selection::select_members(const Value& condition, const std::vector<Value>& a,
                                             const std::vector<Value>& b, Span span) {
  std::vector<Value> selected;
  selected.reserve(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) selected.push_back(select(condition, a[i], b[i], span));
  return selected;
}

const Value& Selection::fixed(const Value& value, Span span) {
  if (value.traced()) {
    follow(equal(value, without_node(value)), span);
  } else if (const List* list = value.as_list()) {
    for (const Value& item : list->items) fixed(item, span);
  } else if (const Record* record = value.object<Record>()) {
    for (const Value& item : record->fields) fixed(item, span);
  }
  return value;
}

}  // namespace solitaire
