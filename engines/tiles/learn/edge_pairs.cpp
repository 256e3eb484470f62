#include "engines/tiles/learn/edge_pairs.h"

#include "engines/tiles/model/edge_label.h"

namespace solitaire::tiles {

bool labels_meet(const std::string& one, const std::string& other) {
  return !one.empty() && one == reversed_label(other);
}

void allow_labelled_pairs(const Tileset& tileset, PairRules& rules) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (std::size_t first = 0; first < tileset.size(); ++first) {
      for (std::size_t second = 0; second < tileset.size(); ++second) {
        const auto a = static_cast<Tile>(first), b = static_cast<Tile>(second);
        if (labels_meet(tileset[a].edges[2 * axis], tileset[b].edges[2 * axis + 1])) rules.allow(axis, a, b);
      }
    }
  }
}

}  // namespace solitaire::tiles
