#include "solitaire/value/plain_copy.h"

namespace solitaire {
namespace {

std::vector<PlainValue> all_plain(const std::vector<Value>& values) {
  std::vector<PlainValue> copies;
  copies.reserve(values.size());
  for (const Value& value : values) copies.push_back(plain(value));
  return copies;
}

PlainValue::Record plain_record(const Record& record) {
  PlainValue::Record copy{record.type->name, {}, all_plain(record.fields)};
  for (std::size_t i = 0; i < record.fields.size(); ++i) copy.names.push_back(record.type->fields[i].name);
  return copy;
}

}  // namespace

PlainValue plain(const Value& value) {
  switch (value.kind()) {
    case Value::Kind::kUnset:
    case Value::Kind::kNil:
      return {};
    case Value::Kind::kBool:
      return {*value.get<bool>()};
    case Value::Kind::kInt:
      return {*value.get<std::int64_t>()};
    case Value::Kind::kFloat:
      return {*value.get<double>()};
    case Value::Kind::kString:
      return {value.object<String>()->text};
    case Value::Kind::kList:
      return {PlainValue::List{all_plain(value.as_list()->items)}};
    case Value::Kind::kRecord:
      return {plain_record(*value.object<Record>())};
    case Value::Kind::kBuiltin:
    case Value::Kind::kClosure:
    case Value::Kind::kRecordType:
    case Value::Kind::kSymbol:
    case Value::Kind::kJoined:
    case Value::Kind::kChosenList:
    case Value::Kind::kUnion:
      break;
  }
  return {PlainValue::Function{to_text(value)}};
}

std::string to_json(const Value& value) { return to_json(plain(value)); }

}  // namespace solitaire
