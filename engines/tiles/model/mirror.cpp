#include "engines/tiles/model/mirror.h"

#include <stdexcept>

namespace solitaire::tiles {

Mirror::Mirror(const Problem& whole, std::size_t axis, std::vector<Tile> partners)
    : size_(whole.size()),
      axis_(axis),
      partners_(std::move(partners)),
      half_(style_of_half(whole.style(), axis, partners_), topology_of_half(whole, axis)) {
  if (!whole.global_rules().empty() || whole.topology().periodic != std::array<bool, kAxes>{}) {
    throw std::invalid_argument("a mirrored map can neither be periodic nor have rules about the whole map");
  }
  std::vector<std::uint8_t> zones;
  for_each_point(half_.size(), [&](const Point& at) {
    zones.push_back(static_cast<std::uint8_t>(whole.zone(size_.site(at))));
    if (zones.back() != whole.zone(size_.site(image(at)))) {
      throw std::invalid_argument("the zones of a mirrored map have to be mirrored, too");
    }
    add_site(whole, at);
  });
  half_.set_zones(std::move(zones));
}

/// Leaves only pairs whose mirror images are allowed as well.
std::shared_ptr<const Style> Mirror::style_of_half(const Style& style, std::size_t axis,
                                                   const std::vector<Tile>& partners) {
  auto result = std::make_shared<Style>(style);
  for (std::size_t zone = 0; zone < style.zones; ++zone) {
    for (std::size_t along = 0; along < kAxes; ++along) {
      for (std::size_t a = 0; a < partners.size(); ++a) {
        for (std::size_t b = 0; b < partners.size(); ++b) {
          const Tile first = partners[along == axis ? b : a], second = partners[along == axis ? a : b];
          if (!style.pairs[zone].allowed(along, first, second)) {
            result->pairs[zone].forbid(along, static_cast<Tile>(a), static_cast<Tile>(b));
          }
        }
      }
    }
  }
  return result;
}

Topology Mirror::topology_of_half(const Problem& whole, std::size_t axis) {
  Size size = whole.size();
  size.extent[axis] = (size.extent[axis] + 1) / 2;
  return {size, {}};
}

Point Mirror::image(const Point& at) const {
  Point result = at;
  result[axis_] = size_.extent[axis_] - 1 - at[axis_];
  return result;
}

TileMask Mirror::images(const TileMask& tiles) const {
  TileMask result;
  tiles.for_each([&](Tile tile) { result.insert(partners_[tile]); });
  return result;
}

/// What holds at a site holds at its mirror image, and a tile at the axis goes with its own image.
void Mirror::add_site(const Problem& whole, const Point& at) {
  const Point there = image(at);
  const std::size_t site = size_.site(at), other = size_.site(there);
  TileMask allowed = whole.domain(site) & images(whole.domain(other));
  for (std::size_t number = 0; number < partners_.size(); ++number) {
    const auto tile = static_cast<Tile>(number);
    const bool fits = site == other ? partners_[tile] == tile
                      : there[axis_] == at[axis_] + 1
                          ? whole.allowed(axis_, site, tile, other, partners_[tile])
                          : true;
    if (!fits) allowed.erase(tile);
  }
  half_.add({"the map is mirrored", {static_cast<std::uint32_t>(half_.size().site(at))}, allowed});
}

Grid Mirror::unfold(const Grid& half) const {
  Grid map(size_);
  for_each_point(half.size, [&](const Point& at) {
    map[size_.site(image(at))] = partners_[half.at(at)];
    map[size_.site(at)] = half.at(at);
  });
  return map;
}

}  // namespace solitaire::tiles
