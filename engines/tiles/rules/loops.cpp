#include "engines/tiles/rules/loops.h"

#include <algorithm>

namespace solitaire::tiles {
namespace {

/// A site on the way of a walk that goes as deep as it can, with the neighbours that it has.
struct Visit {
  std::size_t site, parent;
  std::array<std::size_t, 2 * kAxes> next{};
  std::size_t links = 0, at = 0;
  bool passed_parent = false;
  std::size_t children = 0, cut_off = 0;  // sites first reached from it, and those of them that it cuts off
};

/// Finds sites and links that a network hangs on, by how far back each part of a deep walk reaches (Hopcroft
/// and Tarjan 1973).
class Chokepoints {
 public:
  Chokepoints(const Topology& topology, const std::vector<Sides>& open, const Grid& map)
      : topology_(topology), open_(open), map_(map), order_(map.tiles.size()), back_(map.tiles.size()) {}

  std::uint64_t count() {
    for (std::size_t site = 0; site < map_.tiles.size(); ++site) {
      if (open_[map_[site]] != 0 && order_[site] == 0) walk_from(site);
    }
    return found_;
  }

 private:
  void walk_from(std::size_t site) {
    enter(site, Topology::kNone);
    while (!way_.empty()) {
      Visit& visit = way_.back();
      visit.at < visit.links ? follow(visit) : leave();
    }
  }

  void enter(std::size_t site, std::size_t parent) {
    order_[site] = back_[site] = ++last_;
    Visit& visit = way_.emplace_back(Visit{site, parent});
    for_each_linked(topology_, open_, map_, site,
                    [&](std::size_t next) { visit.next[visit.links++] = next; });
  }

  void follow(Visit& visit) {
    const std::size_t next = visit.next[visit.at++];
    if (next == visit.parent && !visit.passed_parent) {
      visit.passed_parent = true;  // a second link to it, around a ring, is a way back
    } else if (order_[next] == 0) {
      enter(next, visit.site);
    } else {
      back_[visit.site] = std::min(back_[visit.site], order_[next]);
    }
  }

  void leave() {
    const Visit visit = way_.back();
    way_.pop_back();
    const bool is_first = way_.empty();
    found_ += (is_first ? visit.children > 1 : visit.cut_off > 0) ? 1 : 0;
    if (is_first) return;
    Visit& before = way_.back();
    ++before.children;
    if (back_[visit.site] >= order_[before.site]) ++before.cut_off;
    if (back_[visit.site] > order_[before.site]) ++found_;  // the link between the two
    back_[before.site] = std::min(back_[before.site], back_[visit.site]);
  }

  const Topology& topology_;
  const std::vector<Sides>& open_;
  const Grid& map_;
  /// By site: when it was met, counted from 1, and when the earliest site was met that it leads to.
  std::vector<std::uint32_t> order_, back_;
  std::uint32_t last_ = 0;
  std::vector<Visit> way_;
  std::uint64_t found_ = 0;
};

}  // namespace

std::uint64_t Loops::violation(const Grid& map) const { return Chokepoints(topology_, open_, map).count(); }

}  // namespace solitaire::tiles
