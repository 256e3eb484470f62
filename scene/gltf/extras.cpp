#include "scene/gltf/extras.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>

#include "scene/error.h"
#include "scene/text.h"

namespace solitaire {
namespace {

using nlohmann::json;
using GltfValue = tinygltf::Value;

constexpr std::size_t kLongestKey = 63;  // bytes, Blender's MAX_IDPROP_NAME without its terminator

std::optional<GltfValue> to_value(const json& source);

bool fits_int(std::int64_t number) {
  return number >= std::numeric_limits<int>::min() && number <= std::numeric_limits<int>::max();
}

GltfValue integer(std::int64_t number) {
  return fits_int(number) ? GltfValue(static_cast<int>(number)) : GltfValue(std::to_string(number));
}

std::optional<GltfValue> from_list(const json& source) {
  const auto all = [&](auto holds) { return std::all_of(source.begin(), source.end(), holds); };
  const bool uniform =
      all([](const json& e) { return e.is_number(); }) || all([](const json& e) { return e.is_object(); });
  if (source.empty() || !uniform) return std::nullopt;
  GltfValue::Array list;
  for (const json& element : source) {
    auto value = to_value(element);
    if (!value || value->IsString()) return std::nullopt;
    list.push_back(std::move(*value));
  }
  return GltfValue(std::move(list));
}

std::optional<GltfValue> from_object(const json& source) {
  if (source.empty()) return std::nullopt;
  GltfValue::Object object;
  for (const auto& [key, element] : source.items()) {
    auto value = to_value(element);
    if (key.size() > kLongestKey) return std::nullopt;
    object.emplace(key, value ? std::move(*value) : GltfValue(element.dump()));
  }
  return GltfValue(std::move(object));
}

/// Returns nullopt for a value that only JSON text can hold.
std::optional<GltfValue> to_value(const json& source) {
  switch (source.type()) {
    case json::value_t::boolean:
      return GltfValue(source.get<bool>());
    case json::value_t::string:
      return GltfValue(clean_text(source.get<std::string>()));
    case json::value_t::number_float:
      return GltfValue(source.get<double>());
    case json::value_t::number_integer:
      return integer(source.get<std::int64_t>());
    case json::value_t::number_unsigned:
      if (source.get<std::uint64_t>() > INT64_MAX) return std::nullopt;
      return integer(source.get<std::int64_t>());
    case json::value_t::array:
      return from_list(source);
    case json::value_t::object:
      return from_object(source);
    default:
      return std::nullopt;
  }
}

json parsed_extra(const PlacedThing& thing, const std::string& name, const std::string& text) {
  json parsed = json::parse(text, nullptr, false);
  if (parsed.is_discarded())
    throw SceneError(fmt::format("{}: the value of {} is no JSON", thing.source, name));
  return parsed;
}

GltfValue from_json_text(const PlacedThing& thing, const std::string& name, const std::string& text) {
  const json parsed = parsed_extra(thing, name, text);
  auto value = to_value(parsed);
  return value ? std::move(*value) : GltfValue(parsed.dump());
}

struct ChoiceValueWriter {
  GltfValue operator()(bool value) const { return GltfValue(value); }
  GltfValue operator()(std::int64_t value) const { return integer(value); }
  GltfValue operator()(double value) const { return GltfValue(value); }
};

GltfValue choices_value(const std::vector<DecidingChoice>& choices) {
  GltfValue::Array list;
  for (const auto& [address, value] : choices) {
    list.emplace_back(GltfValue::Object{{"at", GltfValue(clean_text(address))},
                                        {"value", std::visit(ChoiceValueWriter{}, value)}});
  }
  return GltfValue(std::move(list));
}

/// Calls add(key, name, text) for each of the program's further arguments; "address" and the like stay ours.
template <typename Taken, typename Add>
void for_each_extra(const PlacedThing& thing, const Taken& is_taken, const Add& add) {
  for (const auto& [name, text] : thing.extras) {
    std::string key = clean_text(name.substr(0, kLongestKey - 1));  // with room for the "_"
    while (is_taken(key)) key += "_";
    add(key, name, text);
  }
}

}  // namespace

std::string facts_text(const PlacedThing& thing, const std::string& name) {
  json facts{{"name", name}, {"address", clean_text(thing.address)}, {"source", clean_text(thing.source)}};
  for (const auto& [address, value] : thing.choices) {
    json choice{{"at", clean_text(address)}};
    std::visit([&](const auto& each) { choice["value"] = each; }, value);
    facts["choices"].push_back(std::move(choice));
  }
  for_each_extra(
      thing, [&](const std::string& key) { return facts.contains(key); },
      [&](const std::string& key, const std::string& extra, const std::string& text) {
        facts[key] = parsed_extra(thing, extra, text);
      });
  return facts.dump();
}

GltfValue make_extras(const PlacedThing& thing) {
  GltfValue::Object extras;
  extras["address"] = GltfValue(clean_text(thing.address));
  extras["source"] = GltfValue(clean_text(thing.source));
  if (!thing.choices.empty()) extras["choices"] = choices_value(thing.choices);
  for_each_extra(
      thing, [&](const std::string& key) { return extras.contains(key); },
      [&](const std::string& key, const std::string& name, const std::string& text) {
        extras.emplace(key, from_json_text(thing, name, text));
      });
  return GltfValue(std::move(extras));
}

}  // namespace solitaire
