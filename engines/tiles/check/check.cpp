#include "engines/tiles/check/check.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <tuple>

namespace solitaire::tiles {
namespace {

/// Zone, axis, first and second tile.
using Pair = std::tuple<std::size_t, std::size_t, Tile, Tile>;

/// Adds the pairs along an axis of a grid, whose last layer meets its first if it is periodic.
void add_pairs(const Exemplar& exemplar, std::size_t axis, std::set<Pair>& pairs) {
  const Point extent = exemplar.grid.size.extent;
  for (int z = 0; z < extent[2]; ++z) {
    for (int y = 0; y < extent[1]; ++y) {
      for (int x = 0; x < extent[0]; ++x) {
        Point next{x, y, z};
        if (++next[axis] == extent[axis]) {
          if (!exemplar.periodic[axis]) continue;
          next[axis] = 0;
        }
        const Tile a = exemplar.grid.at({x, y, z}), b = exemplar.grid.at(next);
        if (a != kHole && b != kHole) pairs.emplace(exemplar.zone, axis, a, b);
      }
    }
  }
}

/// Returns whether labels of two sides that touch are each other's mirror image, part by part.
bool fit_together(const std::string& one, const std::string& other) {
  const auto parts = [](const std::string& label) {
    std::vector<std::string> found(1);
    for (const char letter : label)
      letter == '|' ? (void)found.emplace_back() : found.back().push_back(letter);
    return found;
  };
  std::vector<std::string> here = parts(one), there = parts(other);
  std::ranges::reverse(there);
  return !one.empty() && here == there;
}

void add_labelled_pairs(const Style& style, std::set<Pair>& pairs) {
  const auto tiles = static_cast<Tile>(style.tileset.size());
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (Tile a = 0; a < tiles; ++a) {
      for (Tile b = 0; b < tiles; ++b) {
        if (!fit_together(style.tileset[a].edges[2 * axis], style.tileset[b].edges[2 * axis + 1])) continue;
        for (std::size_t zone = 0; zone < style.zones; ++zone) pairs.emplace(zone, axis, a, b);
      }
    }
  }
}

void add_listed_pairs(const Style& style, std::set<Pair>& pairs) {
  const auto tiles = static_cast<Tile>(style.tileset.size());
  for (const ListedPairs& listed : style.listed) {
    for (Tile a = 0; a < tiles; ++a) {
      for (Tile b = 0; b < tiles; ++b) {
        if (!listed.first.contains(a) || !listed.second.contains(b)) continue;
        for (std::size_t zone = 0; zone < style.zones; ++zone) pairs.emplace(zone, listed.axis, a, b);
      }
    }
  }
}

std::set<Pair> pairs_of(const Style& style) {
  std::set<Pair> allowed, forbidden;
  add_labelled_pairs(style, allowed);
  add_listed_pairs(style, allowed);
  for (const Exemplar& exemplar : style.exemplars) {
    if (!exemplar.negative && !style.learns_from_exemplars) continue;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      add_pairs(exemplar, axis, exemplar.negative ? forbidden : allowed);
    }
  }
  for (const Pair& pair : forbidden) allowed.erase(pair);
  return allowed;
}

std::string place_text(const Grid& map, const Point& at) {
  return map.size.depth() > 1 ? fmt::format("({},{},{})", at[0], at[1], at[2])
                              : fmt::format("({},{})", at[0], at[1]);
}

/// Collects faults up to a number.
class Faults {
 public:
  Faults(const Problem& problem, const Grid& map, std::size_t most)
      : problem_(problem), map_(map), most_(most), pairs_(pairs_of(problem.style())) {}

  std::vector<std::string> find() {
    if (!(map_.size == problem_.size())) return {"the map has another size"};
    look_at_sites();
    for (std::size_t axis = 0; axis < kAxes; ++axis) look_at_pairs(axis);
    for (const auto& rule : problem_.global_rules()) {
      if (!found_.empty()) break;  // such rules suppose a whole map
      if (rule->violation(map_) > 0) add("broken: " + rule->text());
    }
    return std::move(found_);
  }

 private:
  void add(std::string fault) {
    if (found_.size() < most_) found_.push_back(std::move(fault));
  }
  const std::string& name(Tile tile) const { return problem_.style().tileset[tile].name; }

  void look_at_sites() {
    for (std::size_t site = 0; site < map_.tiles.size(); ++site) {
      if (map_[site] < problem_.style().tileset.size()) continue;
      add(fmt::format("{} has no tile", place_text(map_, map_.size.point(site))));
    }
    for (const SiteRule& rule : problem_.site_rules()) {
      for (const std::uint32_t site : rule.sites) {
        const Tile tile = map_[site];
        if (tile == kHole || rule.allowed.contains(tile)) continue;
        add(fmt::format("{} has '{}', but {}", place_text(map_, map_.size.point(site)), name(tile),
                        rule.text));
      }
    }
  }

  void look_at_pairs(std::size_t axis) {
    for (std::size_t site = 0; site < map_.tiles.size(); ++site) {
      const Point at = map_.size.point(site);
      Point next = at;
      if (++next[axis] == map_.size.extent[axis]) {
        if (!problem_.topology().periodic[axis]) continue;
        next[axis] = 0;
      }
      const std::size_t other = map_.size.site(next);
      const Tile a = map_[site], b = map_[other];
      if (a == kHole || b == kHole) continue;
      if (pairs_.contains({problem_.zone(site), axis, a, b})) continue;
      if (pairs_.contains({problem_.zone(other), axis, a, b})) continue;
      static constexpr const char* kBeside[] = {"left of", "above", "below the layer of"};
      add(fmt::format("{} has '{}' {} '{}', which no exemplar has", place_text(map_, at), name(a),
                      kBeside[axis], name(b)));
    }
  }

  const Problem& problem_;
  const Grid& map_;
  std::size_t most_;
  std::set<Pair> pairs_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> find_faults(const Problem& problem, const Grid& map, std::size_t most) {
  return Faults(problem, map, most).find();
}

}  // namespace solitaire::tiles
