#include "engines/tiles/request/site_rules.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engines/tiles/request/names.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/tiled/tileset_files.h"

namespace solitaire::tiles {
namespace {

/// Returns whether a box lies in the map.
bool fits(const PinEntry& box, const Size& size) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.from[axis] < 0 || box.from[axis] >= box.to[axis] || box.to[axis] > size.extent[axis])
      return false;
  }
  return true;
}

[[noreturn]] void fail_outside(const PinEntry& pin, const Size& size) {
  throw RequestError(fmt::format(
      "the pin at ({},{},{}) is outside of the map of {}x{}x{}; make the map larger, or say the place in a "
      "way that suits all sizes: -1 is the last column or row, and \"every\": [10, 10] repeats a pin as "
      "often as it fits",
      pin.from[0], pin.from[1], pin.from[2], size.width(), size.height(), size.depth()));
}

/// Returns the rule of a box that lies in the map.
SiteRule pin_rule(const PinEntry& pin, const Problem& problem) {
  SiteRule rule;
  rule.allowed = tile_set(problem.style().tileset, pin.tiles);
  const Size& size = problem.size();
  const Size box{{pin.to[0] - pin.from[0], pin.to[1] - pin.from[1], pin.to[2] - pin.from[2]}};
  for_each_point(box, [&](const Point& at) {
    rule.sites.push_back(static_cast<std::uint32_t>(
        size.site({pin.from[0] + at[0], pin.from[1] + at[1], pin.from[2] + at[2]})));
  });
  const std::string where = box.volume() == 1 ? fmt::format("({},{})", pin.from[0], pin.from[1])
                                              : fmt::format("({},{}) to ({},{})", pin.from[0], pin.from[1],
                                                            pin.to[0] - 1, pin.to[1] - 1);
  rule.text = fmt::format("{} is pinned to {}", where, quoted(pin.tiles));
  return rule;
}

/// Adds the rule of a pin and of its repetitions along the axes from `axis` on.
void add_pin(PinEntry pin, std::size_t axis, Problem& problem) {
  if (!fits(pin, problem.size())) return;
  if (axis == kAxes) return problem.add(pin_rule(pin, problem));
  do {
    add_pin(pin, axis + 1, problem);
    pin.from[axis] += pin.every[axis];
    pin.to[axis] += pin.every[axis];
  } while (pin.every[axis] > 0 && fits(pin, problem.size()));
}

void add_pin(const PinEntry& said, Problem& problem) {
  const PinEntry pin = counted_in(problem.size(), said);
  if (!fits(pin, problem.size())) fail_outside(said, problem.size());
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (pin.every[axis] > 0 && pin.every[axis] < pin.to[axis] - pin.from[axis])
      throw RequestError("'every' is smaller than the pin's size; 0 repeats it nowhere along that axis");
  }
  add_pin(pin, 0, problem);
}

using Side = std::pair<std::size_t, int>;  // an axis, and a step along it

/// Returns the side of that name.
Side side_named(const std::string& name) {
  static constexpr std::array<const char*, 6> kNames{"right", "left", "bottom", "top", "above", "below"};
  const auto found = std::ranges::find(kNames, name);
  if (found == kNames.end()) {
    throw RequestError(
        fmt::format("'{}' is no side of a map: left, right, top, bottom, below, above or all", name));
  }
  const auto number = static_cast<std::size_t>(found - kNames.begin());
  return {number / 2, number % 2 == 0 ? 1 : -1};
}

/// Returns the sides of these names; "all" are those of axes longer than 1.
std::vector<Side> sides_named(const std::vector<std::string>& names, const Size& size) {
  std::vector<Side> sides;
  for (const std::string& name : names) {
    if (name != "all") {
      sides.push_back(side_named(name));
      continue;
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (size.extent[axis] > 1) sides.insert(sides.end(), {{axis, 1}, {axis, -1}});
    }
  }
  return sides;
}

bool on_one_of(const std::vector<Side>& sides, const Size& size, const Point& at) {
  return std::ranges::any_of(sides, [&](const Side& side) {
    const auto [axis, step] = side;
    return at[axis] == (step > 0 ? size.extent[axis] - 1 : 0);
  });
}

std::string text_of(const BorderEntry& border) {
  std::string area = fmt::format("the border ({})", fmt::join(border.sides, ", "));
  if (!border.except.empty()) area += fmt::format(" without that ({})", fmt::join(border.except, ", "));
  if (border.inside) area = "what is not " + area;
  return fmt::format("{} has {}{}", area, border.forbidden ? "none of " : "", quoted(border.tiles));
}

SiteRule border_rule(const BorderEntry& border, const Problem& problem) {
  const Tileset& tileset = problem.style().tileset;
  SiteRule rule;
  rule.allowed = tile_set(tileset, border.tiles);
  if (border.forbidden) rule.allowed = TileMask::first(tileset.size()).without(rule.allowed);
  rule.text = text_of(border);
  const Size& size = problem.size();
  const std::vector<Side> sides = sides_named(border.sides, size), except = sides_named(border.except, size);
  for_each_point(size, [&](const Point& at) {
    const bool is_border = on_one_of(sides, size, at) && !on_one_of(except, size, at);
    if (is_border != border.inside) rule.sites.push_back(static_cast<std::uint32_t>(size.site(at)));
  });
  return rule;
}

void add_borders(const Request& request, Problem& problem) {
  for (const BorderEntry& border : request.borders) {
    said_at(border.where, [&] { problem.add(border_rule(border, problem)); });
  }
}

}  // namespace

PinEntry counted_in(const Size& size, PinEntry box) {
  const Point last = size.counted({box.to[0] - 1, box.to[1] - 1, box.to[2] - 1});
  box.from = size.counted(box.from);
  for (std::size_t axis = 0; axis < kAxes; ++axis) box.to[axis] = last[axis] + 1;
  return box;
}

void add_site_rules_of_any_size(const Request& request, Problem& problem) {
  for (const PinEntry& pin : request.pins) {
    if (pin.every != Point{}) said_at(pin.where, [&] { add_pin(pin, problem); });
  }
  add_borders(request, problem);
}

void add_site_rules(const Request& request, Problem& problem) {
  for (const PinEntry& pin : request.pins) {
    said_at(pin.where, [&] { add_pin(pin, problem); });
  }
  for (const std::filesystem::path& map : request.pin_maps) {
    for (const TiledPin& pin : read_pins(map)) {
      said_at(map.string(), [&] { add_pin({pin.from, pin.to, pin.tiles}, problem); });
    }
  }
  add_borders(request, problem);
}

}  // namespace solitaire::tiles
