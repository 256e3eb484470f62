#include "solitaire/builtins/placing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
#include "solitaire/value/plain_copy.h"

namespace solitaire {
namespace {

using Call = const BuiltinCall&;

/// The named colours are the basic ones of CSS, and a few that furniture has.
constexpr std::pair<std::string_view, std::uint32_t> kColors[] = {
    {"white", 0xffffff},  {"silver", 0xc0c0c0}, {"gray", 0x808080},   {"grey", 0x808080},
    {"black", 0x202020},  {"red", 0xc83c32},    {"maroon", 0x800000}, {"orange", 0xe8923a},
    {"yellow", 0xf0cf4a}, {"olive", 0x808000},  {"green", 0x4c9a4c},  {"lime", 0x9acd32},
    {"teal", 0x2f8f8f},   {"cyan", 0x5bc8d8},   {"blue", 0x3f6fb5},   {"navy", 0x203864},
    {"purple", 0x7d4f9e}, {"pink", 0xe79ab0},   {"brown", 0x8b5a2b},  {"beige", 0xe6d8b8},
};

/// Reads the arguments of place(). Where they depend on choices, every shape that they can have is checked,
/// and what is read is of no use.
class PlaceReader {
 public:
  PlaceReader(Call call, PlacementChecks& checks) : call_(call), checks_(checks) {}

  Placement read() {
    Placement made;
    each(0, [&](const Value& asset) { made.asset = text("asset", asset); });
    each(1, [&](const Value& at) { std::ranges::copy(numbers("at", at, 2, 3), made.at.begin()); });
    each(2, [&](const Value& size) {
      made.size = numbers("size", size, 2, 3);
      check_all(size, [&](const Value& extent) { check_extent(extent); });
    });
    if (given(argument(3)) && given(argument(4))) fail("angle", "stands beside 'turn': give one of them");
    each(3, [&](const Value& turns) { made.turn = turn(turns); });
    each(4, [&](const Value& angle) { made.angle = number("angle", angle); });
    each(5, [&](const Value& value) { made.color = color(value); });
    each(6, [&](const Value& name) { made.name = text("name", name); });
    for (const auto& [name, value] : call_.extras) {
      if (name == "material") check_material(value);
      made.extras.emplace_back(name, to_json(value));
    }
    return made;
  }

 private:
  const Value& argument(std::size_t number) const { return call_.arguments[number]; }

  /// Reads every shape that an argument can have, if it was given.
  template <class Read>
  void each(std::size_t number, Read read) {
    if (given(argument(number))) each_shape(argument(number), read);
  }
  template <class Read>
  void each_shape(const Value& value, Read read) {
    if (value.has_one_shape()) return void(read(value));
    checks_.each_shape(value, [&](const Value& one) { read(one); });
  }

  [[noreturn]] void fail(const char* parameter, const std::string& why) {
    checks_.fail(span_of(parameter), message(parameter, why));
    std::abort();  // g++ does not see that a virtual function never returns
  }

  Span span_of(std::string_view parameter) const {
    for (const Argument& argument : call_.site.arguments) {
      if (argument.name == parameter) return argument.value->span;
    }
    const bool is_asset = parameter == "asset" && !call_.site.arguments.empty();
    return is_asset ? call_.site.arguments.front().value->span : call_.site.span;
  }

  static std::string message(const char* parameter, const std::string& why) {
    return fmt::format("place: '{}' {}", parameter, why);
  }

  double number(const char* parameter, const Value& value) {
    if (!value.is_number()) fail(parameter, "needs a number, not " + describe(value));
    if (const auto* i = value.get<std::int64_t>()) return static_cast<double>(*i);
    if (const auto* d = value.get<double>()) {
      if (!std::isfinite(*d)) fail(parameter, "is not finite");
      return *d;
    }
    return 0;
  }

  std::vector<double> numbers(const char* parameter, const Value& value, std::size_t least,
                              std::size_t most) {
    if (value.is<Value::Nil>()) return {};
    const List* list = value.as_list();
    if (list == nullptr || list->items.size() < least || list->items.size() > most) {
      fail(parameter, fmt::format("is a list of {} or {} numbers, not {}", least, most, to_text(value)));
    }
    std::vector<double> made(list->items.size());
    for (std::size_t i = 0; i < made.size(); ++i)
      each_shape(list->items[i], [&](const Value& one) { made[i] = number(parameter, one); });
    return made;
  }

  /// For numbers that have been read.
  template <class Check>
  void check_all(const Value& numbers, Check check) {
    if (numbers.is<Value::Nil>()) return;
    for (const Value& item : numbers.as_list()->items) {
      each_shape(item, check);
    }
  }

  void check_extent(const Value& extent) {
    checks_.check_positive(extent, span_of("size"), [&] {
      return message("size", "is made of positive numbers, not " + to_text(extent));
    });
  }

  void check_color_part(const Value& part) {
    checks_.check_part(part, span_of("color"),
                       [] { return message("color", "is a list of red, green and blue, each from 0 to 1"); });
  }

  void check_material(const Value& material) {
    const std::vector<std::string>* known = checks_.materials();
    if (known == nullptr) return;
    each_shape(material, [&](const Value& one) {
      const String* name = one.object<String>();
      if (name == nullptr) fail("material", "is a string, not " + describe(one));
      if (std::ranges::find(*known, name->text) != known->end()) return;
      const std::string nearest = nearest_name(name->text, *known);
      fail("material", fmt::format("has no '{}'; {}", name->text,
                                   nearest.empty() ? fmt::format("there are {}", fmt::join(*known, ", "))
                                                   : fmt::format("did you mean '{}'?", nearest)));
    });
  }

  std::string text(const char* parameter, const Value& value) {
    if (value.is<Value::Nil>()) return "";
    if (value.object<String>() == nullptr) fail(parameter, "is a string, not " + describe(value));
    return value.object<String>()->text;
  }

  int turn(const Value& value) {
    if (!value.has_type(Type::kInt)) fail("turn", "is a number of quarter turns, not " + describe(value));
    const auto* known = value.get<std::int64_t>();
    return known == nullptr ? 0 : static_cast<int>(((*known % 4) + 4) % 4);
  }

  std::optional<std::array<double, 3>> color(const Value& value) {
    if (value.is<Value::Nil>()) return std::nullopt;
    if (value.as_list() != nullptr) {
      const auto parts = numbers("color", value, 3, 3);
      check_all(value, [&](const Value& part) { check_color_part(part); });
      return std::array<double, 3>{parts[0], parts[1], parts[2]};
    }
    if (!is_known(value)) return std::nullopt;
    const std::string name = text("color", value);
    for (const auto& [known, rgb] : kColors) {
      if (known == name) return rgb_of(rgb);
    }
    if (name.size() == 7 && name[0] == '#' &&
        name.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos) {
      return rgb_of(static_cast<std::uint32_t>(std::stoul(name.substr(1), nullptr, 16)));
    }
    std::vector<std::string> names;
    for (const auto& [known, rgb] : kColors) names.emplace_back(known);
    const std::string nearest = nearest_name(name, names);
    fail("color", fmt::format("has no '{}'; {}", name,
                              nearest.empty() ? "write \"#rrggbb\" or [red, green, blue]"
                                              : fmt::format("did you mean '{}'?", nearest)));
  }

  static std::array<double, 3> rgb_of(std::uint32_t rgb) {
    const auto part = [rgb](unsigned shift) { return static_cast<double>((rgb >> shift) & 0xffU) / 255; };
    return {part(16), part(8), part(0)};
  }

  Call call_;
  PlacementChecks& checks_;
};

/// For arguments that a pass over all executions found right.
class NoChecks : public PlacementChecks {
 public:
  void each_shape(const Value& value, const Read& read) override { read(value); }
  [[noreturn]] void fail(Span span, const std::string& message) override {
    throw ProgramError(Diagnostic{span, message, "", {}});
  }
  void check_positive(const Value&, Span, const Message&) override {}
  void check_part(const Value&, Span, const Message&) override {}
  const std::vector<std::string>* materials() override { return nullptr; }
};

}  // namespace

Placement read_placement(const BuiltinCall& call, PlacementChecks& checks) {
  return PlaceReader(call, checks).read();
}

Placement read_placement(const BuiltinCall& call) {
  NoChecks none;
  return PlaceReader(call, none).read();
}

}  // namespace solitaire
