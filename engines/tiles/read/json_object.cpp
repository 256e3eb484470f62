#include "engines/tiles/read/json_object.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"

namespace solitaire::tiles {
namespace {

/// JSON that is nested deeper is refused: it would take the stack.
constexpr int kMostDepth = 64;

}  // namespace

JsonObject::JsonObject(const std::string& file, const Json& json, std::string where)
    : file_(&file), json_(&json), where_(std::move(where)) {
  if (!json.is_object())
    throw FileError(file, fmt::format("{} is no object", where_.empty() ? "the file" : where_));
}

bool JsonObject::has(const char* member) {
  asked_.insert(member);
  return json_->contains(member);
}

const JsonObject::Json& JsonObject::at(const char* member) {
  if (!has(member)) fail(member, "is missing");
  return (*json_)[member];
}

std::string JsonObject::text(const char* member) {
  const Json& value = at(member);
  if (!value.is_string()) fail(member, "is no text");
  return value.get<std::string>();
}

std::string JsonObject::text_or(const char* member, const std::string& otherwise) {
  return has(member) ? text(member) : otherwise;
}

std::int64_t JsonObject::number(const char* member, std::int64_t least, std::int64_t most) {
  const Json& value = at(member);
  const bool fits = value.is_number_integer() &&
                    !(value.is_number_unsigned() && value.get<std::uint64_t>() > std::uint64_t{INT64_MAX}) &&
                    value.get<std::int64_t>() >= least && value.get<std::int64_t>() <= most;
  if (!fits) fail(member, fmt::format("is no whole number from {} to {}", least, most));
  return value.get<std::int64_t>();
}

double JsonObject::real(const char* member, double least, double most) {
  const Json& value = at(member);
  if (!value.is_number() || !(value.get<double>() >= least && value.get<double>() <= most)) {
    fail(member, fmt::format("is no number from {} to {}", least, most));
  }
  return value.get<double>();
}

bool JsonObject::flag(const char* member) {
  if (!has(member)) return false;
  const Json& value = at(member);
  if (!value.is_boolean()) fail(member, "is neither true nor false");
  return value.get<bool>();
}

std::vector<std::string> JsonObject::texts(const char* member) {
  const Json& value = at(member);
  if (value.is_string()) return {value.get<std::string>()};
  if (!value.is_array() || !std::ranges::all_of(value, [](const Json& each) { return each.is_string(); })) {
    fail(member, "is neither a text nor a list of texts");
  }
  return value.get<std::vector<std::string>>();
}

std::vector<int> JsonObject::numbers(const char* member, int least, std::size_t fewest, std::size_t most) {
  const Json& value = at(member);
  const auto fits = [&](const Json& each) {
    return each.is_number_integer() && each.get<std::int64_t>() >= least &&
           each.get<std::int64_t>() <= (1 << 20);
  };
  if (!value.is_array() || value.size() < fewest || value.size() > most ||
      !std::ranges::all_of(value, fits)) {
    fail(member, fmt::format("is no list of {} to {} whole numbers from {}", fewest, most, least));
  }
  return value.get<std::vector<int>>();
}

std::vector<JsonObject> JsonObject::objects(const char* member) {
  std::vector<JsonObject> result;
  if (!has(member)) return result;
  const Json& value = at(member);
  if (!value.is_array()) fail(member, "is no list");
  for (std::size_t i = 0; i < value.size(); ++i) {
    result.emplace_back(*file_, value[i], fmt::format("{}[{}]", way(member), i));
  }
  return result;
}

std::string JsonObject::way(const char* member) const {
  return where_.empty() ? member : fmt::format("{}.{}", where_, member);
}

std::string JsonObject::where() const {
  return where_.empty() ? *file_ : fmt::format("{}: '{}'", *file_, where_);
}

void JsonObject::fail(const char* member, const std::string& reason) const {
  throw FileError(*file_, fmt::format("'{}' {}", way(member), reason));
}

void JsonObject::require_no_more() const {
  const std::vector<std::string> known(asked_.begin(), asked_.end());
  for (const auto& [name, value] : json_->items()) {
    if (asked_.contains(name)) continue;
    const std::string meant = nearest_name(name, known);
    throw FileError(*file_,
                    fmt::format("there is no member '{}'; {}", way(name.c_str()),
                                meant.empty() ? fmt::format("here may stand {}", fmt::join(known, ", "))
                                              : fmt::format("did you mean '{}'?", meant)));
  }
}

nlohmann::json parse_json(const std::string& file, const std::string& text) {
  const auto shallow = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    if (depth > kMostDepth) throw FileError(file, "is nested too deeply");
    return true;
  };
  try {
    return nlohmann::json::parse(text, shallow);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t end = std::min(error.byte > 0 ? error.byte - 1 : 0, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    const std::size_t before = text.rfind('\n', end == 0 ? 0 : end - 1);
    const std::size_t column = before == std::string::npos || end == 0 ? end + 1 : end - before;
    throw FileError(fmt::format("{}:{}:{}", file, line, column), "this is no JSON");
  } catch (const nlohmann::json::out_of_range&) {
    throw FileError(file, "has a number that is too large");
  }
}

}  // namespace solitaire::tiles
