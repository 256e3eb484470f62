#include "engines/tiles/rules/connected.h"

#include "engines/tiles/rules/components.h"
#include "engines/tiles/rules/network_watch.h"

namespace solitaire::tiles {

std::uint64_t Connected::networks(const Grid& map) const {
  Components components(map.tiles.size());
  std::uint64_t count = 0;
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    if (open_[map[site]] != 0) ++count;
  }
  for_each_link(map, [&](std::size_t a, std::size_t b) {
    if (components.join(a, b)) --count;
  });
  return count;
}

std::uint64_t Connected::violation(const Grid& map) const { return superfluous_networks(networks(map)); }

std::unique_ptr<RuleWatch> Connected::watch(const Grid& map) const {
  return std::make_unique<NetworkWatch>(topology_, open_, networks(map));
}

}  // namespace solitaire::tiles
