#pragma once
#include <cstddef>

#include "engines/tiles/model/picture.h"

namespace solitaire::tiles {

/// Returns a colour for the tile with a number that was given none: hues that differ much from each other.
Rgba palette_color(std::size_t number);

}  // namespace solitaire::tiles
