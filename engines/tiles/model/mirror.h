#pragma once
#include <memory>
#include <vector>

#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// Maps whose second half along an axis is the mirror image of the first. Half of the map is a problem of its
/// own, whose maps unfold() makes whole.
///
/// Soft factors are looked at in the half only.
class Mirror {
 public:
  /// `partners` has the mirror image of each tile. The problem has no global rules, and is not periodic.
  /// Throws std::invalid_argument otherwise, or if its zones are not mirrored.
  Mirror(const Problem& whole, std::size_t axis, std::vector<Tile> partners);

  const Problem& half() const { return half_; }
  Grid unfold(const Grid& half) const;

 private:
  static std::shared_ptr<const Style> style_of_half(const Style& style, std::size_t axis,
                                                    const std::vector<Tile>& partners);
  static Topology topology_of_half(const Problem& whole, std::size_t axis);
  void add_site(const Problem& whole, const Point& at);
  Point image(const Point& at) const;
  TileMask images(const TileMask& tiles) const;

  Size size_;  // of the whole
  std::size_t axis_;
  std::vector<Tile> partners_;
  Problem half_;
};

}  // namespace solitaire::tiles
