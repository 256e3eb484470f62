#include "scene/thing_options.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "scene/error.h"

namespace solitaire {
namespace {

using nlohmann::json;

class OptionReader {
 public:
  OptionReader(const PlacedThing& thing, const std::string& name, const std::string& text)
      : thing_(thing), name_(name), text_(text), value_(json::parse(text, nullptr, false)) {}

  std::string string() const {
    if (!value_.is_string()) fail("is a string");
    return value_.get<std::string>();
  }
  bool truth() const {
    if (!value_.is_boolean()) fail("is true or false");
    return value_.get<bool>();
  }
  double number() const {
    if (!value_.is_number() || !std::isfinite(value_.get<double>())) fail("is a number");
    return value_.get<double>();
  }
  double positive() const {
    if (number() <= 0) fail("is a positive number");
    return number();
  }
  /// A string as it is, and anything else as its JSON text.
  std::string text() const { return value_.is_string() ? value_.get<std::string>() : text_; }
  Outline outline() const {
    Outline points;
    for (const json& point : value_) {
      const auto is_number = [](const json& part) { return part.is_number(); };
      if (!point.is_array() || point.size() != 2 || !std::ranges::all_of(point, is_number))
        fail("is a list of points [x, y]");
      points.push_back({point[0].get<double>(), point[1].get<double>()});
    }
    if (const char* fault = fault_of(points); *fault != '\0')
      refuse(thing_, fmt::format("'outline' {}", fault));
    return points;
  }

 private:
  [[noreturn]] void fail(std::string_view wanted) const {
    refuse(thing_, fmt::format("'{}' {}, not {}", name_, wanted, text_));
  }

  const PlacedThing& thing_;
  const std::string& name_;
  const std::string& text_;
  json value_;
};

std::vector<std::string> steps_of(const std::string& path) {
  std::vector<std::string> steps;
  std::istringstream text(path);
  for (std::string step; std::getline(text, step, '/');) {
    if (!step.empty()) steps.push_back(step);
  }
  return steps;
}

}  // namespace

void refuse(const PlacedThing& thing, const std::string& what) {
  throw ThingError(thing.source, what, thing.address);
}

ThingOptions read_options(const PlacedThing& thing) {
  ThingOptions options;
  for (const auto& [name, text] : thing.extras) {
    if (name == "material") options.material = text;
    if (text == "null") continue;  // as if it were not there
    if (name == "tint") options.tint = OptionReader(thing, name, text).truth();
    if (name == "pitch") options.pitch = OptionReader(thing, name, text).number();
    if (name == "roll") options.roll = OptionReader(thing, name, text).number();
    if (name == "scale") options.scale = OptionReader(thing, name, text).positive();
    if (name == "label") options.label = OptionReader(thing, name, text).text();
    if (name == "outline") options.outline = OptionReader(thing, name, text).outline();
    if (name == "extrude") options.extrude = OptionReader(thing, name, text).positive();
    if (name == "parent") options.parents = steps_of(OptionReader(thing, name, text).string());
  }
  return options;
}

}  // namespace solitaire
