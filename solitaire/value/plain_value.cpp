#include "solitaire/value/plain_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace solitaire {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Returns true if the JSON string of the text is the text between quotes.
bool is_plain(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

/// Appends values in the manner of a list, each written by `append`.
template <class Append>
void append_list(std::string& text, char open, std::size_t count, char close, std::string_view between,
                 Append append) {
  text += open;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) text += between;
    append(i);
  }
  text += close;
}

/// Writes JSON. It does so by hand where nothing has to be known about JSON: results are written, and
/// compared, in great numbers.
struct JsonWriter {
  std::string& json;

  void operator()(const PlainValue::Nil&) const { json += "null"; }
  void operator()(bool value) const { json += value ? "true" : "false"; }
  void operator()(std::int64_t value) const { json += std::to_string(value); }
  void operator()(double value) const { json += dumped(unsigned_zero(value)); }
  void operator()(const std::string& text) const { json += json_string(text); }
  void operator()(const PlainValue::List& list) const {
    append_list(json, '[', list.items.size(), ']', ",",
                [&](std::size_t i) { std::visit(*this, list.items[i].is); });
  }
  void operator()(const PlainValue::Record& record) const {
    append_list(json, '{', record.names.size(), '}', ",", [&](std::size_t i) {
      json += json_string(record.names[i]);
      json += ':';
      std::visit(*this, record.values[i].is);
    });
  }
  void operator()(const PlainValue::Function& function) const { json += json_string(function.name); }
};

/// Returns true if a float is one of the language's ints.
bool is_an_int(double value) {
  return std::abs(value) < static_cast<double>(std::int64_t{1} << 62) && value == std::floor(value);
}

/// Writes the value as the language does. With `by_number`, a float that is an int is written as that int.
struct TextWriter {
  std::string& text;
  bool by_number = false;

  void operator()(const PlainValue::Nil&) const { text += "nil"; }
  void operator()(bool value) const { text += value ? "true" : "false"; }
  void operator()(std::int64_t value) const { text += std::to_string(value); }
  void operator()(double value) const {
    text +=
        by_number && is_an_int(value) ? std::to_string(static_cast<std::int64_t>(value)) : float_text(value);
  }
  void operator()(const std::string& string) const { text += json_string(string); }
  void operator()(const PlainValue::List& list) const {
    append_list(text, '[', list.items.size(), ']', ", ",
                [&](std::size_t i) { std::visit(*this, list.items[i].is); });
  }
  void operator()(const PlainValue::Record& record) const {
    text += record.type;
    append_list(text, '(', record.names.size(), ')', ", ", [&](std::size_t i) {
      text += record.names[i];
      text += ": ";
      std::visit(*this, record.values[i].is);
    });
  }
  void operator()(const PlainValue::Function& function) const { text += function.name; }
};

}  // namespace

std::string to_text(const PlainValue& value) {
  std::string text;
  std::visit(TextWriter{text}, value.is);
  return text;
}

std::string text_of_equal(const PlainValue& value) {
  std::string text;
  std::visit(TextWriter{text, true}, value.is);
  return text;
}

std::string to_json(const PlainValue& value) {
  std::string json;
  std::visit(JsonWriter{json}, value.is);
  return json;
}

std::string json_string(std::string_view text) {
  if (!is_plain(text)) return dumped(text);
  std::string quoted = "\"";
  quoted += text;
  return quoted += '"';
}

std::string float_text(double value) {
  std::string text = fmt::format("{}", unsigned_zero(value));
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

}  // namespace solitaire
