#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// The points from `from` to before `to` along each axis.
struct Box {
  Point from{}, to{};

  Size size() const { return {{to[0] - from[0], to[1] - from[1], to[2] - from[2]}}; }
  bool contains(const Point& at) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (at[axis] < from[axis] || at[axis] >= to[axis]) return false;
    }
    return true;
  }
};
inline Box whole_box(const Size& size) { return {{}, size.extent}; }
/// Returns the box with `margin` more on all sides, as far as the grid goes.
Box grown(const Box& box, int margin, const Size& size);

/// A part of a map whose tiles are to be chosen. Outside of it tiles stand, or nothing is said yet.
class Block {
 public:
  /// `domains` are those of all sites. A site outside the box is taken as it is on the map: a tile, or a hole
  /// where nothing is said.
  Block(const Problem& problem, std::span<const TileMask> domains, const Grid& map, const Box& box);

  std::size_t size() const { return sites_.size(); }
  const Problem& problem() const { return *problem_; }
  std::size_t site(std::size_t place) const { return sites_[place]; }
  const TileMask& domain(std::size_t place) const { return domains_[place]; }
  std::size_t zone(std::size_t place) const { return problem_->zone(sites_[place]); }

  /// Calls `visit(neighbour's place, axis, step)` for the neighbours within the block.
  template <class Visit>
  void for_each_neighbor(std::size_t place, Visit visit) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (const int step : {1, -1}) {
        const std::int32_t at = neighbors_[place][2 * axis + (step > 0 ? 0 : 1)];
        if (at >= 0) visit(static_cast<std::size_t>(at), axis, step);
      }
    }
  }

  /// Leaves at a place only tiles of a set.
  void restrict(std::size_t place, const TileMask& tiles);
  /// Takes away tiles that have no partner at some neighbour, until there are none (arc consistency).
  /// Returns false if nothing is left for some place.
  bool propagate();
  /// Returns the places whose domains changed since this was asked last, some of them more than once.
  std::vector<std::uint32_t> take_touched() { return std::exchange(touched_, {}); }
  /// Writes the block's tiles to the map; each domain has one.
  void write_to(Grid& map) const;

 private:
  void meet_standing(const Grid& map, std::size_t place);

  const Problem* problem_;
  std::vector<std::uint32_t> sites_;
  std::vector<TileMask> domains_;
  std::vector<std::array<std::int32_t, 2 * kAxes>> neighbors_;  // places, or -1
  std::vector<std::uint32_t> changed_;                          // places whose neighbours are to be looked at
  std::vector<bool> is_changed_;
  std::vector<std::uint32_t> touched_;  // places whose domains changed
};

}  // namespace solitaire::tiles
