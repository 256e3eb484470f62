#include "engines/tiles/rules/keys.h"

#include "engines/tiles/model/tile_mask.h"
#include "engines/tiles/rules/components.h"

namespace solitaire::tiles {

/// Walks from the first site as far as the keys go that were found on the way. A closed door is seen and
/// waits.
std::vector<bool> Keys::reached(const Grid& map) const {
  std::vector<bool> seen(map.tiles.size());
  if (open_[map[from_]] == 0) return seen;
  std::vector<std::size_t> ready{from_}, closed;
  TileMask found;
  seen[from_] = true;
  const auto take_opened = [&] {
    std::erase_if(closed, [&](std::size_t door) {
      if (!found.contains(*keys_[map[door]])) return false;
      ready.push_back(door);
      return true;
    });
    return !ready.empty();
  };
  while (!ready.empty() || take_opened()) {
    const std::size_t site = ready.back();
    ready.pop_back();
    if (keys_[map[site]] && !found.contains(*keys_[map[site]])) {
      closed.push_back(site);
      continue;
    }
    found.insert(map[site]);
    for_each_linked(topology_, open_, map, site, [&](std::size_t next) {
      if (seen[next]) return;
      seen[next] = true;
      ready.push_back(next);
    });
  }
  for (const std::size_t door : closed) seen[door] = false;
  return seen;
}

std::uint64_t Keys::components_without(const Grid& map, const std::vector<bool>& reached) const {
  Components components(map.tiles.size());
  std::uint64_t count = 0;
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    if (reached[site] || open_[map[site]] == 0) continue;
    ++count;
    for_each_linked(topology_, open_, map, site, [&](std::size_t next) {
      if (next < site && !reached[next] && components.join(site, next)) --count;
    });
  }
  return count;
}

/// A map whose first site is not passable is one worse than one in which nothing else can be reached.
std::uint64_t Keys::violation(const Grid& map) const {
  return components_without(map, reached(map)) + (open_[map[from_]] == 0 ? 1 : 0);
}

}  // namespace solitaire::tiles
