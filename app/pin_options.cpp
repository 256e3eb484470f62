#include "app/pin_options.h"

#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/console.h"
#include "app/report.h"
#include "base/diagnostic.h"
#include "base/file_error.h"

namespace solitaire {
namespace {

using nlohmann::json;

[[noreturn]] void refuse(const std::string& why) {
  tell(fmt::format("error: {}\n", why));
  throw Reported{kUsage};
}

Pin parse_pin(const std::string& text, bool forbidden) {
  const std::string source = fmt::format("{} '{}'", forbidden ? "--forbid" : "--pin", text);
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0) refuse(source + " is not of the form ADDRESS=VALUE");
  const std::string value = text.substr(sign + 1);
  Pin pin{AddressPattern(text.substr(0, sign)), 0, forbidden, source};
  if (value == "true" || value == "false") {
    pin.value = value == "true" ? 1 : 0;
    return pin;
  }
  const char* const end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, pin.value);
  if (error != std::errc{} || stop != end || !is_exact(pin.value))
    refuse(fmt::format("{}: '{}' is no value of a choice; it is an int, true or false", source, value));
  return pin;
}

/// A file that generate wrote, or a line of `solve --json`.
json read_solution(const std::filesystem::path& path) {
  std::ifstream stream(path);
  if (!stream) throw FileError(path.string(), "cannot be read");
  json solution = json::parse(stream, nullptr, false);
  if (solution.is_discarded() || !solution.is_object() || !solution.contains("choices") ||
      !solution["choices"].is_array()) {
    throw FileError(path.string(), "is not the .json file of a solution");
  }
  return solution;
}

std::vector<Pin> pins_of_file(const Options& options) {
  const std::string name = options.pin_file.string();
  std::vector<AddressPattern> keep;
  for (const std::string& pattern : options.keep) keep.emplace_back(pattern);
  std::vector<bool> used(keep.size(), false);
  std::vector<std::vector<std::string>> addresses;
  std::vector<Pin> pins;
  const json solution = read_solution(options.pin_file);
  for (const json& choice : solution["choices"]) {
    if (!choice.is_object() || !choice.contains("at") || !choice["at"].is_string() ||
        !choice.contains("value") || !(choice["value"].is_number_integer() || choice["value"].is_boolean())) {
      throw FileError(name, "has a choice that is not of the form {\"at\": ADDRESS, \"value\": VALUE}");
    }
    const auto address = choice["at"].get<std::string>();
    const json& value = choice["value"];
    const AddressPattern exact(address);
    addresses.push_back(exact.steps());
    bool kept = keep.empty();
    for (std::size_t i = 0; i < keep.size(); ++i) {
      if (!keep[i].matches(exact.steps())) continue;
      used[i] = true;
      kept = true;
    }
    if (!kept) continue;
    const std::int64_t number = value.is_boolean() ? value.get<bool>() : value.get<std::int64_t>();
    pins.push_back({exact, number, false, fmt::format("--pin-file {} ({})", name, address)});
  }
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (used[i]) continue;
    const auto nearest = nearest_patterns(keep[i], addresses, 3);
    refuse(fmt::format("--keep '{}' matches no choice of {}{}", keep[i].text(), name,
                       nearest.empty() ? "" : fmt::format("; the nearest are {}", fmt::join(nearest, ", "))));
  }
  return pins;
}

}  // namespace

std::vector<Pin> read_pins(const Options& options) {
  std::vector<Pin> pins;
  for (const std::string& text : options.pins) pins.push_back(parse_pin(text, false));
  for (const std::string& text : options.forbidden) pins.push_back(parse_pin(text, true));
  if (!options.pin_file.empty()) {
    for (Pin& pin : pins_of_file(options)) pins.push_back(std::move(pin));
  }
  return pins;
}

}  // namespace solitaire
