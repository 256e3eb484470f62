#include "solitaire/value/value.h"

#include <algorithm>
#include <fmt/format.h>

#include "solitaire/value/plain_value.h"

namespace solitaire {
namespace {

std::string function_name(const Closure& closure) {
  return closure.function->name.empty() ? "fun" : "fun " + closure.function->name;
}

std::uint32_t nesting_of(const std::vector<Value>& members) {
  std::uint32_t deepest = 0;
  for (const Value& member : members) deepest = std::max(deepest, nesting(member));
  return deepest + 1;
}

bool same_all(const std::vector<Value>& a, const std::vector<Value>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

/// Of alternatives of a union, and of elements of a list of chosen length.
template <class Guarded>
bool same_guarded(const std::vector<Guarded>& a, const std::vector<Guarded>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Guarded& x, const Guarded& y) {
    return x.guard == y.guard && same(x.value, y.value);
  });
}

}  // namespace

List::List(std::vector<Value> values) : items(std::move(values)), nesting(nesting_of(items)) {}
ChosenList::ChosenList(std::vector<Element> several, bool in_place)
    : elements(std::move(several)), packed(in_place), nesting(1) {
  for (const Element& element : elements) nesting = std::max(nesting, 1 + solitaire::nesting(element.value));
}
Joined::Joined(std::vector<Value> values, Span place)
    : parts(std::move(values)), span(place), nesting(nesting_of(parts)) {}
Record::Record(const RecordStmt* declaration, std::vector<Value> values)
    : type(declaration), fields(std::move(values)), nesting(nesting_of(fields)) {}

std::uint32_t nesting(const Value& value) {
  if (const List* list = value.as_list()) return list->nesting;
  if (const ChosenList* list = value.object<ChosenList>()) return list->nesting;
  if (const Record* record = value.object<Record>()) return record->nesting;
  if (const Joined* joined = value.object<Joined>()) return joined->nesting;
  if (const Union* several = value.as_union()) {
    std::uint32_t deepest = 0;
    for (const auto& alternative : several->alternatives)
      deepest = std::max(deepest, nesting(alternative.value));
    return deepest;
  }
  return 0;
}

bool same(const Value& a, const Value& b) {
  if (a.identical(b)) return true;
  if (a.kind() != b.kind()) return false;
  if (const String* text = a.object<String>()) {
    const String* other = b.object<String>();
    return text->text == other->text && text->opaque == other->opaque;
  }
  if (const Joined* joined = a.object<Joined>()) return same_all(joined->parts, b.object<Joined>()->parts);
  if (const List* list = a.as_list()) return same_all(list->items, b.as_list()->items);
  if (const ChosenList* list = a.object<ChosenList>())
    return same_guarded(list->elements, b.object<ChosenList>()->elements);
  if (const Record* record = a.object<Record>()) {
    return record->type == b.object<Record>()->type && same_all(record->fields, b.object<Record>()->fields);
  }
  if (const Closure* closure = a.object<Closure>()) {
    const Closure* other = b.object<Closure>();
    return closure->function == other->function && closure->outer == other->outer;
  }
  if (const RecordType* type = a.object<RecordType>())
    return type->declaration == b.object<RecordType>()->declaration;
  if (const Union* several = a.as_union())
    return same_guarded(several->alternatives, b.as_union()->alternatives);
  return false;
}

bool is_known(const Value& value) {
  if (const String* text = value.object<String>()) return !text->opaque;
  if (const List* list = value.as_list())
    return std::all_of(list->items.begin(), list->items.end(), is_known);
  if (const Record* record = value.object<Record>())
    return std::all_of(record->fields.begin(), record->fields.end(), is_known);
  return !value.is<Symbol>() && value.has_one_shape();
}

Value Value::string(std::string text) { return make_ref<String>(std::move(text)); }
Value Value::list(std::vector<Value> items) { return make_ref<List>(std::move(items)); }

Value Value::chosen_list(std::vector<GuardedElement> elements, bool packed) {
  std::erase_if(elements, [](const GuardedElement& element) { return element.guard == kFalse; });
  if (std::ranges::any_of(elements, [](const GuardedElement& element) { return element.guard != kTrue; }))
    return make_ref<ChosenList>(std::move(elements), packed);
  std::vector<Value> items;
  items.reserve(elements.size());
  for (GuardedElement& element : elements) items.push_back(std::move(element.value));
  return list(std::move(items));
}

bool Value::identical(const Value& other) const {
  if (kind_ != other.kind_ || node_ != other.node_) return false;
  switch (kind_) {
    case Kind::kUnset:
    case Kind::kNil:
      return true;
    case Kind::kBool:
      return is_.b == other.is_.b;
    case Kind::kInt:
      return is_.i == other.is_.i;
    case Kind::kFloat:
      return is_.f == other.is_.f;
    case Kind::kSymbol:
      return is_.symbol == other.is_.symbol;
    case Kind::kBuiltin:
      return is_.builtin == other.is_.builtin;
    default:
      return is_.object == other.is_.object;
  }
}

void collect_nodes(const Value& value, std::vector<NodeId>& nodes) {
  if (const Symbol* symbol = value.get<Symbol>()) nodes.push_back(symbol->node);
  if (value.traced()) nodes.push_back(value.node());
  if (const List* list = value.as_list()) {
    for (const Value& item : list->items) collect_nodes(item, nodes);
  }
  if (const Record* record = value.object<Record>()) {
    for (const Value& item : record->fields) collect_nodes(item, nodes);
  }
  if (const Joined* joined = value.object<Joined>()) {
    for (const Value& part : joined->parts) collect_nodes(part, nodes);
  }
  const auto collect_guarded = [&](const auto& several) {
    for (const auto& [guard, member] : several) {
      nodes.push_back(guard);
      collect_nodes(member, nodes);
    }
  };
  if (const ChosenList* list = value.object<ChosenList>()) collect_guarded(list->elements);
  if (const Union* several = value.as_union()) collect_guarded(several->alternatives);
}

std::string describe(const Value& value) {
  if (value.has_type(Type::kBool)) return "a bool";
  if (value.has_type(Type::kInt)) return "an int";
  if (value.has_type(Type::kFloat)) return "a float";
  switch (value.kind()) {
    case Value::Kind::kUnset:
      return "nothing yet";
    case Value::Kind::kNil:
      return "nil";
    case Value::Kind::kString:
    case Value::Kind::kJoined:
      return "a string";
    case Value::Kind::kList:
    case Value::Kind::kChosenList:
      return "a list";
    case Value::Kind::kRecord:
      return fmt::format("a record {}", value.object<Record>()->type->name);
    case Value::Kind::kUnion:
      return "one of several";
    default:
      return "a function";
  }
}

std::string to_text(const Value& value) {
  return to_text(value, [](NodeId) { return std::string("?"); });
}

std::string to_text(const Value& value, const NodeName& name) {
  const auto joined = [&name](const std::vector<Value>& items, const char* between = ", ") {
    std::string text;
    for (const Value& item : items) text += (text.empty() ? "" : between) + to_text(item, name);
    return text;
  };
  const auto guarded = [&name](const auto& several, const char* between) {
    std::string text;
    for (const auto& [guard, member] : several)
      text += fmt::format("{}{} if {}", text.empty() ? "" : between, to_text(member, name), name(guard));
    return text;
  };
  switch (value.kind()) {
    case Value::Kind::kUnset:
      return "nothing yet";
    case Value::Kind::kNil:
      return "nil";
    case Value::Kind::kBool:
      return *value.get<bool>() ? "true" : "false";
    case Value::Kind::kInt:
      return std::to_string(*value.get<std::int64_t>());
    case Value::Kind::kFloat:
      return float_text(*value.get<double>());
    case Value::Kind::kSymbol:
      return name(value.get<Symbol>()->node);
    case Value::Kind::kBuiltin:
      return fmt::format("fun {}", (*value.get<Value::BuiltinRef>())->name);
    case Value::Kind::kString:
      return json_string(value.object<String>()->text);
    case Value::Kind::kJoined:
      return joined(value.object<Joined>()->parts, " + ");
    case Value::Kind::kList:
      return "[" + joined(value.as_list()->items) + "]";
    case Value::Kind::kChosenList:
      return "[" + guarded(value.object<ChosenList>()->elements, ", ") + "]";
    case Value::Kind::kRecord: {
      const Record& record = *value.object<Record>();
      std::string text;
      for (std::size_t i = 0; i < record.fields.size(); ++i) {
        text += fmt::format("{}{}: {}", i == 0 ? "" : ", ", record.type->fields[i].name,
                            to_text(record.fields[i], name));
      }
      return fmt::format("{}({})", record.type->name, text);
    }
    case Value::Kind::kClosure:
      return function_name(*value.object<Closure>());
    case Value::Kind::kRecordType:
      return "record " + value.object<RecordType>()->declaration->name;
    case Value::Kind::kUnion:
      return "(" + guarded(value.as_union()->alternatives, " | ") + ")";
  }
  return "";
}

}  // namespace solitaire
