#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "engines/count/nested/nested_bounds.h"

namespace solitaire {

/// Returns an order of all clusters in which bounds fall fast: at each place of an attempt to draw a
/// solution, the cluster comes next that makes the total the smallest. Returns nothing where no attempt comes
/// to an end. Throws Interrupted and NestedBounds::TooMuchWork.
std::optional<std::vector<std::size_t>> order_of_clusters(NestedBounds& bounds, RandomStream& random,
                                                          const StopSignal& stop);

}  // namespace solitaire
