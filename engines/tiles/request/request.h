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
#include "engines/tiles/model/symmetry.h"

namespace solitaire::tiles {

// Entries say in `where` which file and member says so, for messages; nothing where their text does.

/// What the author says about a tile.
struct TileEntry {
  std::string name;
  std::string text;  // its character in text maps
  std::optional<Rgba> color;
  std::optional<std::array<int, 2>> icon;  // column and row in the picture of icons
  std::filesystem::path icon_file;         // or a picture of its own
  std::filesystem::path voxel_file;        // its model, of many voxels (.vox)
  double bias = 1;
  std::optional<std::uint8_t> voxel;                       // the number of its colour in .vox models
  std::string asset;                                       // the model of scenes
  int turn = 0;                                            // quarter turns of the model
  std::vector<std::pair<std::string, std::string>> edges;  // the letter of a side, or *, and its label
  std::string symmetry;          // the letter of the turned tiles that there are, too
  double height = 1;             // of the box where there is no model, in sides of a tile
  bool rotates = true;           // else exemplars that are turned have a hole in its place
  std::string turned, mirrored;  // the tile that it is after a quarter turn clockwise, and left to right
  std::string where = "";
};

/// What the author says about a tile that comes from an exemplar.
struct RemarkEntry {
  std::string name;
  double bias = 1;
  std::string turned, mirrored;  // as of TileEntry
  std::string where = "";
};

/// Any of the tiles `first` may be before any of `second` along an axis.
struct AdjacencyEntry {
  std::size_t axis = 0;
  std::vector<std::string> first, second;
  std::string where = "";
};

struct ExemplarEntry {
  std::filesystem::path file;
  std::string zone;
  bool negative = false;
  std::array<bool, kAxes> periodic{};  // where they are longer than 1
  std::string empty = "";              // the tile that its holes are; else nothing is learned of them
};

/// Sites from `from` to before `to` that may only have these tiles. Places below 0 are counted from the far
/// side of the map.
struct PinEntry {
  Point from{}, to{};
  std::vector<std::string> tiles;
  std::string where = "";
  Point every{};  // sites along each axis after which the box is repeated while it fits; 0: it is not
};

/// The tiles that may be on some sides of the map.
struct BorderEntry {
  std::vector<std::string> sides;  // left, right, top, bottom, below, above, all
  std::vector<std::string> tiles;
  std::vector<std::string> except = {};  // sites on these sides do not belong to the border
  bool inside = false;                   // all sites but those of the border are meant
  bool forbidden = false;                // these tiles may not be there, rather than others
  std::string where = "";
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
  std::string where = "";
  SymmetryGroup symmetry = {};  // what is said of a tile in `open` is said of its images, too
};

/// How many of these tiles a map has.
struct CountEntry {
  std::vector<std::string> tiles;
  std::uint64_t least = 0, most = UINT64_MAX;
  std::string where = "";
  double least_share = 0, most_share = 1;  // of all sites
};

/// The longest run of these tiles along an axis, or along all.
struct RunEntry {
  std::vector<std::string> tiles;
  std::optional<std::size_t> axis;
  std::uint64_t most = 1;
  std::string where = "";
};

/// How many steps any two of these tiles are apart at least, or any of them from any of the others if there
/// are such.
struct DistanceEntry {
  std::vector<std::string> tiles, others;
  int least = 1;
  std::string where = "";
};

/// Two sites between which a path over these tiles leads.
struct PathEntry {
  Point from{}, to{};
  ConnectedEntry over;
  std::string where = "";
};

/// Where one begins to walk, over which tiles, and which doors need which keys.
struct KeysEntry {
  Point from{};
  ConnectedEntry over;
  std::vector<std::pair<std::string, std::string>> doors;  // a door and its key
  std::string where = "";
};

/// The second half of the map is the mirror image of the first. Tiles without a partner are their own.
struct MirrorEntry {
  std::size_t axis = 0;
  std::vector<std::pair<std::string, std::string>> partners;
  bool by_look = false;  // the partners of other tiles are those that look like their mirror images
  std::string where = "";
};

enum class WeightsKind : std::uint8_t {
  kStep,
  kFitted,
  kRead,  // from a file
};

/// Which pairs of tiles are allowed, where there are both exemplars and labels of sides.
enum class PairsFrom : std::uint8_t { kSeen, kLabels, kBoth };

/// What a tile is in a turned exemplar of which nobody says it.
enum class UnknownImages : std::uint8_t {
  kByLook,  // the one that looks so; a hole without one
  kItself,
  kNothing,  // a hole
};

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
  std::filesystem::path icons;   // the picture of the tiles' icons
  std::optional<int> tile_side;  // pixels of a tile in PNG exemplars and icons; 1 unless said
  std::vector<ExemplarEntry> exemplars;
  SymmetryGroup symmetry;  // exemplars and adjacencies count in all these orientations
  UnknownImages unknown_images = UnknownImages::kByLook;
  std::vector<RemarkEntry> remarks;
  std::vector<AdjacencyEntry> adjacencies;
  std::optional<double> icon_tolerance;  // tiles may be beside each other whose icons differ by no more there
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
  std::vector<ConnectedEntry> acyclic;  // networks without a way round
  std::vector<ConnectedEntry> loops;    // networks in which two ways lead everywhere
  std::vector<CountEntry> counts;
  std::vector<RunEntry> runs;
  std::vector<DistanceEntry> distances;
  std::vector<PathEntry> paths;
  std::vector<KeysEntry> keys;
  std::optional<MirrorEntry> mirror;
  std::vector<std::string> notes;  // what whoever asks should know about how it was understood

  int side_of_tiles() const { return tile_side.value_or(1); }
};

}  // namespace solitaire::tiles
