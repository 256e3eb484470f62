#include "engines/tiles/rules/longest_run.h"

namespace solitaire::tiles {

std::uint64_t LongestRun::violation(const Grid& map) const {
  std::uint64_t excess = 0;
  for (const std::size_t axis : axes_) {
    Size starts = map.size;
    starts.extent[axis] = 1;
    for_each_point(starts, [&](Point at) {
      std::uint64_t run = 0;
      for (; at[axis] < map.size.extent[axis]; ++at[axis]) {
        run = tiles_.contains(map.at(at)) ? run + 1 : 0;
        if (run > most_) ++excess;
      }
    });
  }
  return excess;
}

}  // namespace solitaire::tiles
