#pragma once
#include <vector>

#include "engines/tiles/model/grid.h"

namespace solitaire::tiles {

/// Returns the paper's set of block shapes B1 to B6, each of which has those before it: 1x1; 2x1 and 1x2;
/// 2x2; 4x1 and 1x4; 3x3; 4x4.
std::vector<Size> block_shapes(int set);

}  // namespace solitaire::tiles
