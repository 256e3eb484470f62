#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "engines/tiles/model/grid.h"

namespace solitaire::tiles {

/// A way to lay a flat map down anew: mirrored left to right, and then turned clockwise by so many quarters.
struct Symmetry {
  bool mirrored = false;
  int turns = 0;

  /// Returns where a distance leads afterwards.
  Point apply(Point distance) const {
    if (mirrored) distance[0] = -distance[0];
    for (int turn = 0; turn < turns; ++turn) distance = {-distance[1], distance[0], distance[2]};
    return distance;
  }
  /// Returns whether x and y change places.
  bool swaps_axes() const { return turns % 2 == 1; }
  bool is_identity() const { return !mirrored && turns == 0; }
};

/// In which orientations something counts.
struct SymmetryGroup {
  int turns = 1;  // 1, 2 or 4 of them make a whole turn
  bool mirrored = false;

  std::vector<Symmetry> members() const {
    std::vector<Symmetry> all;
    for (const bool mirror : {false, true}) {
      for (int turn = 0; turn < turns && (mirrored || !mirror); ++turn)
        all.push_back({mirror, turn * 4 / turns});
    }
    return all;
  }
};

/// Returns the group of that name: none, mirror (left to right), 4 (all turns) or 8 (all turns, mirrored
/// too).
inline std::optional<SymmetryGroup> symmetry_named(std::string_view name) {
  if (name == "none") return SymmetryGroup{1, false};
  if (name == "mirror") return SymmetryGroup{1, true};
  if (name == "4") return SymmetryGroup{4, false};
  if (name == "8") return SymmetryGroup{4, true};
  return std::nullopt;
}

}  // namespace solitaire::tiles
