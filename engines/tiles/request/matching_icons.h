#pragma once
#include "engines/tiles/model/style.h"

namespace solitaire::tiles {

/// Lets tiles be beside each other in flat maps whose icons look alike where they touch: the channels of the
/// pixels along the side that they share differ by `tolerance` on average at the most, where 1 is the
/// distance of black and white. Throws RequestError if a tile has no icon.
void add_pairs_of_matching_icons(double tolerance, Style& style);

}  // namespace solitaire::tiles
