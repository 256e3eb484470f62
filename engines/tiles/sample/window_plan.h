#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engines/tiles/model/problem.h"
#include "engines/tiles/sample/factor_rows.h"
#include "engines/tiles/sample/tile_classes.h"
#include "engines/tiles/sample/weights.h"

namespace solitaire::tiles {

/// Tiles of sites of a window that later factors still need, packed: each has a slot of so many bits.
using FrontierKey = PatchCode;

/// A soft factor whose tiles are all known once a site of the window has got its tile.
struct ClosingFactor {
  struct Part {
    unsigned slot;   // first bit of the tile in the key
    unsigned shift;  // and in the patch's code
  };

  FactorRows* rows;                    // what the patches weigh, by all of their tiles but the chosen one
  PatchCode standing;                  // the code's part of tiles around the window
  std::uint32_t first_part, end_part;  // tiles of the window, among the parts of the plan
};

/// A pair of the site with an earlier one of the window.
struct ClosingPair {
  const PairRules* rules;
  std::size_t axis;
  int step;  // from the earlier site to this one
  unsigned slot;
};

/// A slot whose tiles are told apart by their class alone from some step on.
struct NarrowedSlot {
  unsigned slot;
  const Tile* classes;
};

/// What happens when a site of a window gets its tile.
struct PlanStep {
  std::uint32_t site;
  TileMask tiles;           // that go with the domain and the tiles around the window
  std::vector<double> own;  // by tile: the product of factors that depend on no other site of the window
  std::vector<ClosingPair> pairs;
  std::vector<ClosingFactor> factors;
  FrontierKey kept = 0;                // the bits of the key that are needed afterwards
  bool needed = false;                 // the site's own tile is
  unsigned slot = 0;                   // then this is its place in the key,
  const Tile* classes = nullptr;       // and what stands there for each tile; null: the tile itself
  std::vector<NarrowedSlot> narrowed;  // of earlier sites, after this step
};

/// How a window is redrawn: its sites in order, and the factors that close at each.
class WindowPlan {
 public:
  /// Prepares for windows of a problem.
  explicit WindowPlan(const Problem& problem);

  /// Lays out the window of these sites, chosen in this order; the other sites are as on the map. Returns
  /// false if more sites would have to be remembered at a time than fit a key.
  bool lay_out(const Grid& map, std::span<const std::uint32_t> sites, Weights& weights);

  std::span<const PlanStep> steps() const { return {steps_.data(), used_}; }
  std::span<const ClosingFactor::Part> parts(const ClosingFactor& factor) const {
    return {parts_.data() + factor.first_part, factor.end_part - factor.first_part};
  }

 private:
  static constexpr std::uint32_t kOutside = UINT32_MAX;

  /// A shape as it lies around the site that closes its factor.
  struct Placement {
    std::size_t shape;
    std::size_t own;                        // the number of that site in the shape
    Point first{};                          // from that site to the shape's first corner
    std::vector<std::ptrdiff_t> distances;  // from that site to the others, in site numbers
    std::vector<Point> offsets;             // the same in places
    std::vector<unsigned> shifts;           // of the others' tiles in the code
  };

  void add_placements(std::size_t shape);
  bool is_inside(const Placement& placement, const Point& at) const;
  void find_pairs(const Grid& map, std::uint32_t place);
  void find_factors(const Grid& map, std::uint32_t place, Weights& weights);
  bool find_sites(const Placement& placement, const Point& at, std::size_t site);
  void close_factor(const Grid& map, std::uint32_t place, const Placement& placement, Weights& weights);
  void need(std::uint32_t place, std::uint32_t until);
  bool assign_slots();
  void narrow(std::uint32_t place, std::uint32_t of);
  const Tile* classes_after(std::uint32_t place, std::uint32_t of);
  std::uint32_t place_of(std::size_t site) const {
    const std::uint32_t place = places_[site];
    return place < used_ && steps_[place].site == site ? place : kOutside;
  }

  const Problem& problem_;
  std::vector<Placement> placements_;
  std::vector<std::size_t> sites_;     // of the placement at work, but for the closing one
  std::vector<std::uint32_t> places_;  // by site: its place in the window, if it is there
  std::vector<PlanStep> steps_;        // the first used_ of them are the plan
  std::size_t used_ = 0;
  std::vector<ClosingFactor::Part> parts_;   // of all factors
  std::vector<std::uint32_t> needed_until_;  // by place: the last step that needs its tile
  std::vector<unsigned> slot_of_;            // by place
  TileClasses classes_;
  std::vector<std::uint32_t> told_apart_until_;  // by place: the last step with a factor of it,
  std::vector<std::array<std::uint32_t, 2 * kAxes>> neighbor_chosen_;  // and with the neighbour on each side
};

}  // namespace solitaire::tiles
