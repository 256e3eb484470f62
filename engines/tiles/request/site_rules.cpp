#include "engines/tiles/request/site_rules.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "engines/tiles/request/names.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/tiled/tileset_files.h"

namespace solitaire::tiles {
namespace {

SiteRule pin_rule(const PinEntry& pin, const Problem& problem) {
  SiteRule rule;
  rule.allowed = tile_set(problem.style().tileset, pin.tiles);
  const Size& size = problem.size();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (pin.from[axis] >= 0 && pin.from[axis] < pin.to[axis] && pin.to[axis] <= size.extent[axis]) continue;
    throw RequestError(fmt::format("the pin at ({},{},{}) is outside of the map of {}x{}x{}", pin.from[0],
                                   pin.from[1], pin.from[2], size.width(), size.height(), size.depth()));
  }
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

}  // namespace

void add_site_rules(const Request& request, Problem& problem) {
  for (const PinEntry& pin : request.pins) {
    said_at(pin.where, [&] { problem.add(pin_rule(pin, problem)); });
  }
  for (const std::filesystem::path& map : request.pin_maps) {
    for (const TiledPin& pin : read_pins(map)) {
      said_at(map.string(), [&] { problem.add(pin_rule({pin.from, pin.to, pin.tiles}, problem)); });
    }
  }
  for (const BorderEntry& border : request.borders) {
    said_at(border.where, [&] { problem.add(border_rule(border, problem)); });
  }
}

}  // namespace solitaire::tiles
