#pragma once
#include "base/random.h"
#include "engines/tiles/model/style.h"

namespace solitaire::tiles::bench {

/// Makes a map by texture synthesis: in reading order each site gets a tile of the exemplar whose tiles above
/// and to the left differ least from those that stand (causal neighbourhoods of Wei and Levoy, 2000, with
/// Hamming's distance). Nothing keeps it from putting tiles beside each other that do not belong there.
Grid synthesize_texture(const Style& style, const Size& size, RandomStream& random);

/// Returns how many pairs of a map no exemplar has.
std::size_t broken_pairs(const Style& style, const Grid& map);

}  // namespace solitaire::tiles::bench
