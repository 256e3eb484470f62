#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engines/tiles/model/grid.h"
#include "engines/tiles/model/picture.h"

namespace solitaire::tiles {

/// What the author says about a tile.
struct TileEntry {
  std::string name;
  std::string text;  // its character in text maps
  std::optional<Rgba> color;
  std::optional<std::array<int, 2>> icon;  // column and row in the picture of icons
  double bias = 1;
};

struct ExemplarEntry {
  std::filesystem::path file;
  std::string zone;
  bool negative = false;
  bool periodic = false;  // along all axes longer than 1
};

/// Sites from `from` to before `to` that may only have these tiles.
struct PinEntry {
  Point from{}, to{};
  std::vector<std::string> tiles;
};

/// The tiles that may be on one side of the map, or on all sides.
struct BorderEntry {
  std::string side;  // left, right, top, bottom, below, above, all
  std::vector<std::string> tiles;
};

/// A picture whose colours are zones; each of its pixels is a site, or a square of sites.
struct ZoneMap {
  std::filesystem::path file;
  std::vector<std::pair<Rgba, std::string>> legend;  // by the names of zones
};

/// Tiles that must form one connected network.
struct ConnectedEntry {
  std::vector<std::string> tiles;
  std::vector<std::pair<std::string, std::string>>
      open;  // a tile and the letters of its open sides (l r t b)
};

/// How many of these tiles a map has.
struct CountEntry {
  std::vector<std::string> tiles;
  std::uint64_t least = 0, most = UINT64_MAX;
};

enum class WeightsKind : std::uint8_t { kStep, kFitted };

/// A problem in the words of its author, before any file is read but the one that says it.
struct Request {
  std::vector<TileEntry> tiles;
  std::filesystem::path icons;  // the picture of the tiles' icons
  int tile_side = 1;            // pixels of a tile in PNG exemplars and icons
  std::vector<ExemplarEntry> exemplars;
  Point size{20, 20, 1};
  std::array<bool, kAxes> periodic{};
  std::vector<Size> shapes;  // of soft factors; empty: those for the kind of weights
  WeightsKind weights = WeightsKind::kFitted;
  double epsilon = 0.1;
  std::vector<PinEntry> pins;
  std::vector<BorderEntry> borders;
  std::optional<ZoneMap> zones;
  std::vector<ConnectedEntry> connected;
  std::vector<CountEntry> counts;
};

}  // namespace solitaire::tiles
