#include "solitaire/value/short_text.h"

#include <algorithm>
#include <vector>

#include "solitaire/value/plain_copy.h"

namespace solitaire {
namespace {

/// Returns true for what is written in a few characters, by itself.
bool is_short_scalar(const Value& value) {
  if (value.is<Value::Nil>() || value.is<bool>() || value.is<std::int64_t>() || value.is<double>())
    return true;
  const auto* text = value.object<String>();
  return text != nullptr && !text->opaque && text->text.size() <= kShortText;
}

bool are_short_scalars(const std::vector<Value>& values) {
  return values.size() <= kShortList && std::ranges::all_of(values, is_short_scalar);
}

bool is_short(const Value& value) {
  if (const List* list = value.as_list()) return are_short_scalars(list->items);
  if (const auto* record = value.object<Record>()) return are_short_scalars(record->fields);
  return is_short_scalar(value) || value.is_function();
}

}  // namespace

std::string short_text(const Value& value) {
  if (!is_short(value)) return "";
  std::string text = to_text(plain(value));
  const bool is_nameless = text == "fun";
  return text.size() <= kShortText + 2 && !is_nameless ? text : "";
}

}  // namespace solitaire
