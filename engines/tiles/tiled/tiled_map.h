#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engines/tiles/model/grid.h"

namespace solitaire::tiles {

/// The colours of a Wang set around a tile: of its top side, the corner at the top right, its right side, and
/// so on clockwise. Empty where there is none.
using WangColors = std::array<std::string, 8>;

/// What the custom properties of a tile say, as far as they are read.
struct TiledProperties {
  std::string name, asset;
  double weight = 1;
  bool rotates = true;  // the property "rotate"
};

/// A tileset of a Tiled map.
struct TiledTileset {
  std::uint32_t first_gid = 1;
  std::string name;
  int tile_width = 0, tile_height = 0, columns = 0, spacing = 0, margin = 0;
  std::filesystem::path image;  // empty: its tiles are single pictures, which are not read
  std::map<std::uint32_t, TiledProperties> properties;  // by number in the set
  std::map<std::uint32_t, WangColors> wang;  // of tiles in the first Wang set, by number in the set
};

/// A rectangle of the object layer "pins": sites from `from` to before `to` have one of the tiles.
struct TiledPin {
  Point from{0, 0, 0}, to{1, 1, 1};
  std::vector<std::string> tiles;
};

/// What is read of a map of the editor Tiled: its visible layers of tiles.
struct TiledMap {
  int width = 0, height = 0;
  /// From below, each in rows from the top; 0 where no tile is.
  std::vector<std::vector<std::uint32_t>> layers;
  std::vector<TiledTileset> tilesets;
  std::vector<TiledPin> pins;
};

/// Collects the layers of a map, which may be in chunks.
class TiledLayers {
 public:
  /// Begins the next layer, above the others. Throws FileError if there are too many.
  void begin(const std::string& file);
  /// Adds a rectangle of gids to the last layer. Throws FileError if they are not as many as the rectangle
  /// has, or if the map gets too large.
  void add(const std::string& file, std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height,
           const std::vector<std::uint32_t>& gids);
  /// Writes the smallest rectangle around all to the map. Throws FileError if there is nothing.
  void write_to(const std::string& file, TiledMap& map) const;

 private:
  struct Chunk {
    std::size_t layer;
    std::int64_t x, y, width, height;
    std::vector<std::uint32_t> gids;
  };
  std::vector<Chunk> chunks_;
  std::size_t layers_ = 0;
};

/// Decodes the data of a layer. `encoding` is csv or base64, `compression` empty, zlib, gzip or zstd; `count`
/// gids are wanted, and no more memory than for these is taken. Throws FileError.
std::vector<std::uint32_t> decode_gids(const std::string& file, const std::string& text,
                                       const std::string& encoding, const std::string& compression,
                                       std::size_t count);

/// Returns what the property "weight" of a tile says. Throws FileError for what is no weight.
double checked_weight(const std::string& file, double weight);

/// A rectangle in pixels, as Tiled has it.
struct TiledObject {
  std::string name;
  double x = 0, y = 0, width = 0, height = 0;
};
/// Returns the pin that an object of the layer "pins" is, whose name has tiles with | between them, in a map
/// whose tiles have so many pixels. Throws FileError.
TiledPin pin_of(const std::string& file, const TiledObject& object, int tile_width, int tile_height);

/// Returns the colours that a Wang set gives to a tile: `ids` are numbers of its colours from 1, or 0. Throws
/// FileError.
WangColors wang_colors(const std::string& file, const std::vector<std::int64_t>& ids,
                       const std::vector<std::string>& colors);

/// Returns a file that a map names, which must be in the map's folder or below. Throws FileError.
std::filesystem::path file_beside(const std::filesystem::path& map, const std::string& named);

/// Reads a map (.tmx, .tmj) from the bytes of its file, with its tilesets or without. Throws FileError.
TiledMap read_tmx(const std::filesystem::path& path, const std::string& bytes, bool with_tilesets = true);
TiledMap read_tmj(const std::filesystem::path& path, const std::string& bytes, bool with_tilesets = true);

}  // namespace solitaire::tiles
