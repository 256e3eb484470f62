#include "engines/tiles/rules/network_watch.h"

#include "engines/tiles/rules/network_rule.h"

namespace solitaire::tiles {

NetworkWatch::NetworkWatch(const Topology& topology, const std::vector<Sides>& open, std::uint64_t networks)
    : topology_(topology),
      open_(open),
      networks_(networks),
      tried_(networks),
      part_(topology.size.volume()) {}

std::uint64_t NetworkWatch::after(const Grid& map, const Change& change) {
  find_changed(map, change);
  find_doors(map);
  walk_outside(map);
  tried_ = networks_ + networks_here(now_, map) - networks_here(before_, map);
  forget();
  return superfluous_networks(tried_);
}

void NetworkWatch::find_changed(const Grid& map, const Change& change) {
  changed_.clear(), before_.clear(), now_.clear(), walks_.clear();
  for (std::size_t i = 0; i < change.sites.size(); ++i) {
    const std::uint32_t site = change.sites[i];
    if (map[site] == change.before[i]) continue;
    changed_.push_back(site);
    before_.push_back(change.before[i]);
    now_.push_back(map[site]);
    part_[site] = static_cast<std::uint32_t>(changed_.size());
  }
}

/// Finds the sites beside those that changed that were linked to them, or are now.
void NetworkWatch::find_doors(const Grid& map) {
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    const Sides open = open_[before_[i]] | open_[now_[i]];
    const Point at = map.size.point(changed_[i]);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (const int step : {1, -1}) {
        const std::size_t next = topology_.neighbor(at, axis, step);
        if ((open & side(axis, step)) == 0 || next == Topology::kNone || part_[next] != 0) continue;
        if ((open_[map[next]] & side(axis, -step)) == 0) continue;
        walks_.push_back({{static_cast<std::uint32_t>(next)}, 0});
        part_[next] = static_cast<std::uint32_t>(changed_.size() + walks_.size());
      }
    }
  }
}

/// Walks from all doors in turns, until those walks that go on have met each other.
void NetworkWatch::walk_outside(const Grid& map) {
  joined_ = Components(changed_.size() + walks_.size());
  while (!is_known()) {
    for (std::size_t walk = 0; walk < walks_.size(); ++walk) {
      if (!walks_[walk].is_over()) step(map, walk);
    }
  }
}

/// Leaves a site of a walk to its neighbours.
void NetworkWatch::step(const Grid& map, std::size_t walk) {
  const std::size_t number = changed_.size() + walk;
  for_each_linked(topology_, open_, map, walks_[walk].sites[walks_[walk].next++], [&](std::size_t next) {
    if (is_changed(next)) return;
    if (part_[next] != 0) {
      joined_.join(number, part_[next] - 1);
      return;
    }
    part_[next] = static_cast<std::uint32_t>(number + 1);
    walks_[walk].sites.push_back(static_cast<std::uint32_t>(next));
  });
}

/// Returns whether no two walks can meet any more that have not met: one that is over has seen all it could.
bool NetworkWatch::is_known() {
  std::size_t going = SIZE_MAX;
  for (std::size_t walk = 0; walk < walks_.size(); ++walk) {
    if (walks_[walk].is_over()) continue;
    const std::size_t group = joined_.root(changed_.size() + walk);
    if (going != SIZE_MAX && group != going) return false;
    going = group;
  }
  return true;
}

/// Returns how many networks there are among the doors and the sites that changed, with these tiles.
std::uint64_t NetworkWatch::networks_here(const std::vector<Tile>& tiles, const Grid& map) const {
  Components joined = joined_;
  std::uint64_t count = 0;
  for (std::size_t walk = 0; walk < walks_.size(); ++walk) {
    const std::size_t number = changed_.size() + walk;
    count += joined.root(number) == number ? 1 : 0;
  }
  for (const Tile tile : tiles) count += open_[tile] != 0 ? 1 : 0;
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    const Point at = map.size.point(changed_[i]);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (const int step : {1, -1}) {
        const std::size_t next = topology_.neighbor(at, axis, step);
        if ((open_[tiles[i]] & side(axis, step)) == 0 || next == Topology::kNone) continue;
        const Tile other = is_changed(next) ? tiles[part_[next] - 1] : map[next];
        if ((open_[other] & side(axis, -step)) == 0) continue;
        if (joined.join(i, part_[next] - 1)) --count;
      }
    }
  }
  return count;
}

void NetworkWatch::forget() {
  for (const std::uint32_t site : changed_) part_[site] = 0;
  for (const Walk& walk : walks_) {
    for (const std::uint32_t site : walk.sites) part_[site] = 0;
  }
}

}  // namespace solitaire::tiles
