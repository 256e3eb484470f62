#include "engines/tiles/model/style.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace solitaire::tiles {

double SoftShape::log_weight(ZoneSet zones, std::uint32_t patch) const {
  double most = -std::numeric_limits<double>::infinity();
  for (ZoneSet rest = zones; rest != 0; rest &= rest - 1) {
    most = std::max(most, log_weights[static_cast<std::size_t>(std::countr_zero(rest))][patch]);
  }
  return most;
}

}  // namespace solitaire::tiles
