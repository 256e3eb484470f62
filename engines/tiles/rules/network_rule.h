#pragma once
#include <string>
#include <utility>
#include <vector>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Calls `visit(neighbour)` for each neighbour of a site where each is open towards the other; `open` has the
/// open sides of each tile.
template <class Visit>
void for_each_linked(const Topology& topology, const std::vector<Sides>& open, const Grid& map,
                     std::size_t site, Visit visit) {
  const Sides here = open[map[site]];
  if (here == 0) return;
  const Point at = map.size.point(site);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const int step : {1, -1}) {
      if ((here & side(axis, step)) == 0) continue;
      const std::size_t next = topology.neighbor(at, axis, step);
      if (next != Topology::kNone && (open[map[next]] & side(axis, -step)) != 0) visit(next);
    }
  }
}

/// A rule about the network of a map's passable tiles, in which two neighbours are linked if each is open
/// towards the other.
class NetworkRule : public GlobalRule {
 public:
  /// `open` has the open sides of each tile; 0 for those that are not passable.
  NetworkRule(const Topology& topology, std::vector<Sides> open, std::string text)
      : topology_(topology), open_(std::move(open)), text_(std::move(text)) {}

  std::string text() const override { return text_; }

 protected:
  /// Calls `visit(site, next)` for every link once.
  template <class Visit>
  void for_each_link(const Grid& map, Visit visit) const {
    for_each_point(map.size, [&](const Point& at) {
      const std::size_t site = map.size.site(at);
      const Sides here = open_[map[site]];
      for (std::size_t axis = 0; axis < kAxes && here != 0; ++axis) {
        if ((here & side(axis, 1)) == 0) continue;
        const std::size_t next = topology_.neighbor(at, axis, 1);
        if (next != Topology::kNone && (open_[map[next]] & side(axis, -1)) != 0) visit(site, next);
      }
    });
  }

  Topology topology_;
  std::vector<Sides> open_;

 private:
  std::string text_;
};

}  // namespace solitaire::tiles
