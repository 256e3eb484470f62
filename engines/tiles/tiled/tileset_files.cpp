#include "engines/tiles/tiled/tileset_files.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <stdexcept>

#include "base/file_error.h"
#include "engines/tiles/model/palette.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/read/png.h"
#include "engines/tiles/tiled/gid_flags.h"

namespace solitaire::tiles {
namespace {

/// Returns the colours around a tile that is turned as its flags say. They stand around a square of 3x3
/// places.
WangColors turned(const WangColors& colors, std::uint32_t gid) {
  static constexpr std::array<std::array<int, 2>, 8> kPlaces{
      {{1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {0, 0}}};
  WangColors result;
  for (std::size_t place = 0; place < kPlaces.size(); ++place) {
    auto [x, y] = kPlaces.at(place);
    turn_place(gid, 3, x, y);
    const auto from = std::ranges::find(kPlaces, std::array<int, 2>{x, y});
    result.at(place) = colors.at(static_cast<std::size_t>(from - kPlaces.begin()));
  }
  return result;
}

/// Returns the labels of a tile's sides: what its Wang set says of the corner before, the side, and the
/// corner behind it, clockwise. A side of which it says nothing has the label "none".
std::array<std::string, 2 * kAxes> edges_of(const WangColors& colors) {
  constexpr std::size_t kRight = 2, kBottom = 4, kLeft = 6, kTop = 0;
  const auto label = [&](std::size_t side) {
    std::string text;
    for (const std::size_t place : {(side + 7) % 8, side, side + 1}) {
      if (!colors.at(place).empty()) text += (text.empty() ? "" : "|") + colors.at(place);
    }
    return text.empty() ? "none" : text;
  };
  return {label(kRight), label(kLeft), label(kBottom), label(kTop), "", ""};
}

/// The tiles of a map's tilesets, with their pictures.
class TiledTiles {
 public:
  TiledTiles(const std::filesystem::path& path, const TiledMap& map) : file_(path.string()), map_(map) {
    for (const TiledTileset& tileset : map.tilesets) {
      const bool has_picture = !tileset.image.empty() && tileset.image.extension() == ".png";
      pictures_.push_back(has_picture ? read_png(tileset.image.string(), read_bytes(tileset.image))
                                      : Picture());
    }
  }

  TileKind kind(std::uint32_t gid, std::size_t number) const {
    const std::uint32_t plain = gid & ~kFlags;
    std::size_t set = map_.tilesets.size();
    for (std::size_t each = 0; each < map_.tilesets.size(); ++each) {
      if (map_.tilesets[each].first_gid > plain) continue;
      if (set == map_.tilesets.size() || map_.tilesets[each].first_gid > map_.tilesets[set].first_gid)
        set = each;
    }
    if (set == map_.tilesets.size()) throw FileError(file_, fmt::format("no tileset has the gid {}", plain));
    const TiledTileset& tileset = map_.tilesets[set];
    const std::uint32_t id = plain - tileset.first_gid;
    TileKind kind;
    std::string name = fmt::format("{}#{}", tileset.name, id);
    if (const auto found = tileset.properties.find(id); found != tileset.properties.end()) {
      if (!found->second.name.empty()) name = found->second.name;
      kind.asset = found->second.asset;
      kind.bias = found->second.weight;
      kind.rotates = found->second.rotates;
    }
    kind.parts = {{gid & ~kFlipHexagonal, std::move(name)}};
    kind.name = name_of_parts(kind.parts);
    kind.gid = kind.parts.front().gid;
    kind.icon = icon(tileset, pictures_[set], id, gid);
    kind.color = kind.icon.empty() ? palette_color(number) : mean_color(kind.icon);
    if (const auto wang = tileset.wang.find(id); wang != tileset.wang.end())
      kind.edges = edges_of(turned(wang->second, gid));
    return kind;
  }

  /// Returns the tile of several layers, of which some may have none.
  TileKind stacked_kind(const std::vector<std::uint32_t>& gids, std::size_t number) const {
    std::optional<TileKind> stacked;
    std::vector<TiledPart> parts;
    for (const std::uint32_t gid : gids) {
      if ((gid & ~kFlags) == 0) {
        parts.emplace_back();
        continue;
      }
      TileKind layer = kind(gid, number);
      parts.push_back(layer.parts.front());
      if (!stacked) {
        stacked = std::move(layer);
      } else {
        put_over(layer, *stacked);
      }
    }
    stacked->parts = std::move(parts);
    stacked->gid = stacked->parts.front().gid;
    stacked->name = name_of_parts(stacked->parts);
    return std::move(*stacked);
  }

 private:
  /// Draws a tile over another one.
  static void put_over(const TileKind& above, TileKind& below) {
    if (below.icon.width == above.icon.width && below.icon.height == above.icon.height) {
      for (std::size_t at = 0; at < below.icon.pixels.size(); ++at) {
        if (above.icon.pixels[at][3] >= 128) below.icon.pixels[at] = above.icon.pixels[at];
      }
      if (!below.icon.empty()) below.color = mean_color(below.icon);
    }
    below.bias *= above.bias;
    below.rotates = below.rotates && above.rotates;
    if (below.asset.empty()) below.asset = above.asset;
  }

  /// Returns the square of a tile, turned as its flags say; empty if it is not in the picture.
  static Picture icon(const TiledTileset& tileset, const Picture& picture, std::uint32_t id,
                      std::uint32_t gid) {
    const int side = tileset.tile_width;
    if (picture.empty() || side < 1 || side != tileset.tile_height || tileset.columns < 1) return {};
    const auto columns = static_cast<std::uint32_t>(tileset.columns);
    const std::int64_t step = std::int64_t{side} + tileset.spacing;
    const std::int64_t left = tileset.margin + step * (id % columns),
                       top = tileset.margin + step * (id / columns);
    if (left < 0 || top < 0 || left + side > picture.width || top + side > picture.height) return {};
    Picture result(side, side);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        int from_x = x, from_y = y;
        turn_place(gid, side, from_x, from_y);
        result.at(x, y) = picture.at(static_cast<int>(left) + from_x, static_cast<int>(top) + from_y);
      }
    }
    return result;
  }

  std::string file_;
  const TiledMap& map_;
  std::vector<Picture> pictures_;  // by tileset
};

}  // namespace

TiledTileset read_tileset(const std::filesystem::path& path) {
  return path.extension() == ".tsj" || path.extension() == ".json" ? read_tsj(path) : read_tsx(path);
}

bool is_tileset(const std::filesystem::path& file) {
  return file.extension() == ".tsx" || file.extension() == ".tsj";
}

bool is_tiled(const std::filesystem::path& file) {
  return file.extension() == ".tmx" || file.extension() == ".tmj";
}

void read_tiles_of(const std::filesystem::path& path, Tileset& tileset) {
  TiledMap map;
  map.tilesets.push_back(read_tileset(path));
  if (map.tilesets.front().wang.empty())
    throw FileError(path.string(),
                    "has no Wang set, which would say what may be beside what; name a map that uses it");
  const TiledTiles tiles(path, map);
  for (const auto& [id, colors] : map.tilesets.front().wang) {
    TileKind kind = tiles.kind(id + 1, tileset.size());
    if (tileset.find(kind.name)) continue;
    try {
      tileset.add(std::move(kind));
    } catch (const std::length_error& error) {
      throw FileError(path.string(), error.what());
    }
  }
}

void read_numbered_tiles_of(const std::filesystem::path& path, const std::set<std::uint32_t>& numbers,
                            Tileset& tileset) {
  TiledMap map;
  map.tilesets.push_back(read_tileset(path));
  const TiledTiles tiles(path, map);
  for (const std::uint32_t number : numbers) {
    TileKind kind = number == 0 ? empty_kind("empty") : tiles.kind(number, tileset.size());
    if (number == 0) kind.gid = 0;
    try {
      if (!tileset.find(kind.name)) tileset.add(std::move(kind));
    } catch (const std::length_error& error) {
      throw FileError(path.string(), error.what());
    }
  }
}

namespace {

/// Returns the tile of the tileset that is called as a kind is, which is added to an open tileset.
Tile tile_of(const std::filesystem::path& path, TileKind kind, Tileset& tileset, bool open) {
  if (const auto tile = tileset.find(kind.name)) return *tile;
  if (!open)
    throw FileError(path.string(), fmt::format("has '{}', which is no tile of the tileset", kind.name));
  try {
    return tileset.add(std::move(kind));
  } catch (const std::length_error& error) {
    throw FileError(path.string(), error.what());
  }
}

}  // namespace

std::vector<TiledPin> read_pins(const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  if (ending != ".tmx" && ending != ".tmj")
    throw FileError(path.string(), "is no map of Tiled (.tmx, .tmj), whose object layer \"pins\" has pins");
  TiledMap map = ending == ".tmj" ? read_tmj(path, read_bytes(path)) : read_tmx(path, read_bytes(path));
  if (map.pins.empty()) throw FileError(path.string(), "has no object layer \"pins\" with rectangles");
  return std::move(map.pins);
}

namespace {

bool has_tiled_tiles(const Tileset& tileset) {
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    if (!tileset[static_cast<Tile>(tile)].parts.empty()) return true;
  }
  return false;
}

/// Returns the gids that a tile has in the layers of a map.
std::vector<std::uint32_t> gids_of(const TileKind& kind, std::size_t layers) {
  std::vector<std::uint32_t> gids(layers);
  if (kind.parts.empty()) gids.front() = kind.gid.value_or(0);
  for (std::size_t layer = 0; layer < kind.parts.size() && layer < layers; ++layer)
    gids[layer] = kind.parts[layer].gid;
  return gids;
}

/// Returns the tiles of known gids: a map that was written after the pattern of the exemplar has those of its
/// tilesets, wherever these are.
std::map<std::vector<std::uint32_t>, Tile> tiles_by_gids(const Tileset& tileset, std::size_t layers) {
  std::map<std::vector<std::uint32_t>, Tile> tiles;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const TileKind& kind = tileset[static_cast<Tile>(tile)];
    if (kind.gid) tiles.emplace(gids_of(kind, layers), static_cast<Tile>(tile));
  }
  return tiles;
}

bool is_empty(const std::vector<std::uint32_t>& gids) {
  return std::ranges::all_of(gids, [](std::uint32_t gid) { return (gid & ~kFlags) == 0; });
}

std::string text_of_gids(const std::vector<std::uint32_t>& gids) {
  std::string text;
  for (const std::uint32_t gid : gids)
    text += (text.empty() ? "" : "+") + std::to_string(gid & ~kFlags) + flag_letters(gid);
  return text;
}

}  // namespace

Grid read_tiled(const std::filesystem::path& path, Tileset& tileset, bool open) {
  const bool by_gids = !open && has_tiled_tiles(tileset);
  const std::string bytes = read_bytes(path);
  const TiledMap map =
      path.extension() == ".tmj" ? read_tmj(path, bytes, !by_gids) : read_tmx(path, bytes, !by_gids);
  const TiledTiles tiles(path, map);
  std::map<std::vector<std::uint32_t>, Tile> known;
  if (by_gids) known = tiles_by_gids(tileset, map.layers.size());
  Grid grid(Size{{map.width, map.height, 1}});
  for (std::size_t site = 0; site < grid.tiles.size(); ++site) {
    std::vector<std::uint32_t> gids;
    for (const std::vector<std::uint32_t>& layer : map.layers) gids.push_back(layer[site] & ~kFlipHexagonal);
    auto found = known.find(gids);
    if (found == known.end() && is_empty(gids)) continue;
    if (found == known.end() && by_gids)
      throw FileError(path.string(),
                      fmt::format("has the gid {}, which is no tile of the tileset", text_of_gids(gids)));
    if (found == known.end())
      found =
          known.emplace(gids, tile_of(path, tiles.stacked_kind(gids, tileset.size()), tileset, open)).first;
    grid[site] = found->second;
  }
  return grid;
}

}  // namespace solitaire::tiles
