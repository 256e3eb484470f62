#pragma once
#include <array>
#include <string>
#include <vector>

#include "engines/tiles/model/grid.h"
#include "engines/tiles/model/pair_rules.h"
#include "engines/tiles/model/patch_index.h"
#include "engines/tiles/model/tile_mask.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// The most zones that a style tells apart: a set of zones is a word of so many bits.
inline constexpr std::size_t kMostZones = 32;
using ZoneSet = std::uint32_t;

/// A small map to learn from.
struct Exemplar {
  Grid grid;
  std::array<bool, kAxes> periodic{};
  std::uint8_t zone = 0;
  bool negative = false;  // its pairs are forbidden
  std::string name;       // of the file, for messages
};

/// The soft factor of one shape: what a patch at any place of a map multiplies the map's probability by, as a
/// natural logarithm.
struct SoftShape {
  PatchIndex patches;
  std::vector<std::vector<double>> log_weights;  // by zone and the patch's number; [0] is for unknown patches

  /// Returns the weight where a patch lies in several zones: that of the zone which favours it most.
  double log_weight(ZoneSet zones, std::uint32_t patch) const;
};

/// Any of the tiles `first` may be before any of `second` along an axis, in all zones: a rule of its author.
struct ListedPairs {
  std::size_t axis = 0;
  TileMask first, second;
};

/// What was learned of exemplars: whatever is the same for maps of all sizes.
struct Style {
  Tileset tileset;
  std::vector<Exemplar> exemplars;
  bool learns_from_exemplars = true;  // their pairs are allowed; else only those whose labels meet
  std::vector<ListedPairs> listed;
  std::size_t zones = 1;
  std::vector<PairRules> pairs;  // by zone; across zones a pair is allowed that one of them allows
  std::vector<SoftShape> shapes;
  std::vector<std::vector<double>> frequencies;  // of tiles in the exemplars, by zone, adding up to 1
};

}  // namespace solitaire::tiles
