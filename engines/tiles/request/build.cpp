#include "engines/tiles/request/build.h"

#include <algorithm>
#include <fmt/format.h>
#include <stdexcept>

#include "base/file_error.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/read/png.h"
#include "engines/tiles/request/global_rules.h"
#include "engines/tiles/request/names.h"
#include "engines/tiles/request/site_rules.h"
#include "engines/tiles/request/tile_images.h"

namespace solitaire::tiles {
namespace {

/// Returns the zone of every site, by the colours of a picture that is stretched over the map.
std::vector<std::uint8_t> read_zones(const ZoneMap& map, const Size& size,
                                     const std::vector<std::string>& names) {
  const Picture picture = read_png(map.file.string(), read_bytes(map.file));
  std::vector<std::uint8_t> zones;
  zones.reserve(size.volume());
  for_each_point(size, [&](const Point& at) {
    const Rgba& color = picture.at_share(at[0], size.width(), at[1], size.height());
    const auto found = std::ranges::find(map.legend, color, &std::pair<Rgba, std::string>::first);
    if (found == map.legend.end()) {
      throw FileError(map.file.string(),
                      fmt::format("the colour #{:02x}{:02x}{:02x} for ({},{}) is in no legend", color[0],
                                  color[1], color[2], at[0], at[1]));
    }
    zones.push_back(zone_number(names, found->second));
  });
  return zones;
}

/// Returns each tile's image in the mirror.
std::vector<Tile> partners_of(const Request& request, Tileset tileset) {
  std::vector<Tile> partners;
  const std::size_t tiles = tileset.size();
  TileImages images(tileset, request.unknown_images);
  // Upside down is mirrored left to right and turned by a half.
  const Symmetry symmetry{true, request.mirror->axis == 1 ? 2 : 0};
  for (std::size_t tile = 0; tile < tiles; ++tile) {
    const Tile itself = static_cast<Tile>(tile);
    partners.push_back(request.mirror->by_look ? images.image(itself, symmetry).value_or(itself) : itself);
    if (partners.back() >= tiles) partners.back() = itself;  // an image that the exemplar does not have
  }
  for (const auto& [name, partner] : request.mirror->partners) {
    const Tile a = tile_called(tileset, name), b = tile_called(tileset, partner);
    partners[a] = b;
    partners[b] = a;
  }
  return partners;
}

}  // namespace

Problem make_problem(const Request& request, std::shared_ptr<const Style> style) {
  Problem problem(std::move(style), {{request.size}, request.periodic});
  add_site_rules(request, problem);
  if (request.zones) problem.set_zones(read_zones(*request.zones, problem.size(), zone_names(request)));
  add_global_rules(request, problem);
  return problem;
}

std::vector<std::uint8_t> zones_by_tile(const Request& request, const Tileset& coarse) {
  const std::vector<std::string> names = zone_names(request);
  std::vector<std::uint8_t> zones;
  for (const std::string& tile : coarse.names()) zones.push_back(zone_number(names, tile));
  return zones;
}

std::optional<Mirror> make_mirror(const Request& request, const Problem& problem) {
  if (!request.mirror) return std::nullopt;
  std::optional<Mirror> mirror;
  said_at(request.mirror->where, [&] {
    try {
      mirror.emplace(problem, request.mirror->axis, partners_of(request, problem.style().tileset));
    } catch (const std::invalid_argument& error) {
      throw RequestError(error.what());
    }
  });
  return mirror;
}

}  // namespace solitaire::tiles
