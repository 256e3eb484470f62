#include "engines/tiles/rules/acyclic.h"

#include "engines/tiles/rules/components.h"

namespace solitaire::tiles {

std::uint64_t Acyclic::violation(const Grid& map) const {
  Components components(map.tiles.size());
  std::uint64_t superfluous = 0;
  for_each_link(map, [&](std::size_t a, std::size_t b) { superfluous += components.join(a, b) ? 0 : 1; });
  return superfluous;
}

}  // namespace solitaire::tiles
