#pragma once
#include <span>

#include "engines/tiles/model/style.h"

namespace solitaire::tiles {

/// How far the patches of maps are from those of the exemplars.
struct Divergence {
  double kullback_leibler = 0;  // of the maps from the exemplars, in nats
  double jensen_shannon = 0;    // of both from their mean, in nats; at most ln 2
};

/// Compares the patches of a shape. The counts of the maps are scaled to the total of the exemplars, and each
/// patch that occurs on either side counts half more than it occurs, so that no patch makes the divergence
/// infinite. Zero for shapes that do not fit the exemplars or the maps.
Divergence divergence(const Style& style, std::span<const Grid> maps, const Size& shape);

}  // namespace solitaire::tiles
