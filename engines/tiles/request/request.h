#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
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
  std::optional<std::uint8_t> voxel;                       // the number of its colour in .vox models
  std::string asset;                                       // the model of scenes
  int turn = 0;                                            // quarter turns of the model
  std::vector<std::pair<std::string, std::string>> edges;  // the letter of a side, or *, and its label
  std::string symmetry;  // the letter of the turned tiles that there are, too
  double height = 1;     // of the box where there is no model, in sides of a tile
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
      open;                        // a tile and the letters of its open sides (l r t b)
  std::vector<std::string> edges;  // tiles are open on the sides with one of these labels
};

/// How many of these tiles a map has.
struct CountEntry {
  std::vector<std::string> tiles;
  std::uint64_t least = 0, most = UINT64_MAX;
};

/// The longest run of these tiles along an axis, or along all.
struct RunEntry {
  std::vector<std::string> tiles;
  std::optional<std::size_t> axis;
  std::uint64_t most = 1;
};

/// How many steps any two of these tiles are apart at least.
struct DistanceEntry {
  std::vector<std::string> tiles;
  int least = 1;
};

/// Two sites between which a path over these tiles leads.
struct PathEntry {
  Point from{}, to{};
  ConnectedEntry over;
};

/// Where one begins to walk, over which tiles, and which doors need which keys.
struct KeysEntry {
  Point from{};
  ConnectedEntry over;
  std::vector<std::pair<std::string, std::string>> doors;  // a door and its key
};

/// The second half of the map is the mirror image of the first. Tiles without a partner are their own.
struct MirrorEntry {
  std::size_t axis = 0;
  std::vector<std::pair<std::string, std::string>> partners;
};

enum class WeightsKind : std::uint8_t {
  kStep,
  kFitted,
  kRead,  // from a file
};

/// Which pairs of tiles are allowed, where there are both exemplars and labels of sides.
enum class PairsFrom : std::uint8_t { kSeen, kLabels, kBoth };

struct Request;

/// Zones that are drawn anew for each map: a coarse map, each of whose tiles is the zone of a square of
/// sites.
struct DistrictsEntry {
  std::shared_ptr<const Request> coarse;
  int scale = 8;  // sites of the map along a side of a coarse tile
};

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
  std::filesystem::path weights_file;  // of WeightsKind::kRead
  std::optional<PairsFrom> pairs;      // nothing: exemplars, and what the problem file says of sides
  double epsilon = 0.1;
  std::vector<PinEntry> pins;
  std::vector<std::filesystem::path> pin_maps;  // maps of Tiled whose object layer "pins" has pins
  std::vector<BorderEntry> borders;
  std::optional<ZoneMap> zones;
  std::optional<DistrictsEntry> districts;
  std::vector<ConnectedEntry> connected;
  std::vector<CountEntry> counts;
  std::vector<RunEntry> runs;
  std::vector<DistanceEntry> distances;
  std::vector<PathEntry> paths;
  std::vector<KeysEntry> keys;
  std::optional<MirrorEntry> mirror;
};

}  // namespace solitaire::tiles
