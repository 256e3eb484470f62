#pragma once
#include "engines/tiles/model/style.h"

namespace solitaire::tiles {

/// Lets tiles be beside each other whose icons look alike where they touch: the channels of the pixels along
/// the side that they share differ by `tolerance` on average at the most, where 1 is the distance of black
/// and white. If all tiles have models of voxels these are compared, also of tiles above each other: the
/// share of voxels that differ. Throws RequestError if a tile has no icon.
void add_pairs_of_matching_icons(double tolerance, Style& style);

}  // namespace solitaire::tiles
