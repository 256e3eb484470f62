#include "engines/tiles/request/names.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <optional>

#include "engines/tiles/request/request_error.h"
#include "engines/tiles/tiled/gid_flags.h"

namespace solitaire::tiles {
namespace {

/// Returns the tile with that number in the file that it was read from.
std::optional<Tile> tile_numbered(const Tileset& tileset, const std::string& text) {
  std::uint32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const TileKind& kind = tileset[static_cast<Tile>(tile)];
    const bool is_stacked =
        kind.parts.size() > 1 && name_of_parts(kind.parts) != name_of_parts({kind.parts.front()});
    if ((kind.gid == number && !is_stacked) || kind.voxel == number) return static_cast<Tile>(tile);
  }
  return std::nullopt;
}

}  // namespace

std::string quoted(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += fmt::format("{}'{}'", text.empty() ? "" : ", ", name);
  return text;
}

Tile tile_called(const Tileset& tileset, const std::string& name) {
  if (const auto tile = tileset.find(name)) return *tile;
  if (const auto tile = tile_numbered(tileset, name)) return *tile;
  throw RequestError(fmt::format("there is no tile '{}'; the tiles are {}", name, quoted(tileset.names())));
}

TileMask tile_set(const Tileset& tileset, const std::vector<std::string>& names) {
  TileMask mask;
  for (const std::string& name : names) mask.insert(tile_called(tileset, name));
  return mask;
}

std::vector<std::string> zone_names(const Request& request) {
  std::vector<std::string> names;
  for (const ExemplarEntry& exemplar : request.exemplars) {
    if (std::ranges::find(names, exemplar.zone) == names.end()) names.push_back(exemplar.zone);
  }
  return names;
}

std::uint8_t zone_number(const std::vector<std::string>& names, const std::string& zone) {
  const auto found = std::ranges::find(names, zone);
  if (found == names.end()) {
    throw RequestError(fmt::format("no exemplar has the zone '{}'; there are {}", zone, quoted(names)));
  }
  return static_cast<std::uint8_t>(found - names.begin());
}

Sides sides_of(const std::string& letters) {
  Sides sides = 0;
  for (const char letter : letters) {
    const std::size_t place = std::string("rlbtud").find(letter);
    if (place == std::string::npos) {
      throw RequestError(fmt::format("'{}' is no side; l, r, t, b, u and d are", letter));
    }
    sides |= static_cast<Sides>(1U << place);
  }
  return sides;
}

}  // namespace solitaire::tiles
