#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/model/uniform.h"
#include "engines/tiles/sample/block_shapes.h"
#include "engines/tiles/sample/sampler.h"
#include "engines/tiles/sample/slice.h"

namespace solitaire::tiles {
namespace {

// The paper's parameters.
constexpr double kTemperature = 0.25;
constexpr double kWalk = 0.6;
constexpr double kFlip = 0.1;
/// Steps for each site before a search gives up; the paper does not say its number.
constexpr std::uint64_t kStepsPerSite = 400;
/// Steps for each site before a search begins again with random tiles, as WalkSAT does: it may be where no
/// single block helps.
constexpr std::uint64_t kStepsPerTry = 20;

/// A block shape, with all patches of that shape in the exemplars; equal ones are there as often as they
/// occur.
struct Blocks {
  Size shape;
  std::vector<std::vector<Tile>> patches;
};

Blocks blocks_of(const Style& style, const Size& shape) {
  Blocks blocks{shape, {}};
  for (const Exemplar& exemplar : style.exemplars) {
    if (exemplar.negative) continue;
    const Topology topology{exemplar.grid.size, exemplar.periodic};
    for_each_point(exemplar.grid.size, [&](const Point& at) {
      std::vector<Tile> tiles;
      for_each_point(shape, [&](const Point& offset) {
        const std::size_t site = topology.site(at, offset);
        if (site != Topology::kNone && exemplar.grid[site] != kHole) tiles.push_back(exemplar.grid[site]);
      });
      if (tiles.size() == shape.volume()) blocks.patches.push_back(std::move(tiles));
    });
  }
  return blocks;
}

/// The search for a map in a slice (the paper's algorithm 2).
class BlockSearch {
 public:
  BlockSearch(const Problem& problem, int set, std::uint64_t key)
      : problem_(problem), slice_(problem), random_(key, Purpose::kTiles, UINT64_MAX), map_(problem.size()) {
    for (const Size& shape : block_shapes(set)) {
      blocks_.push_back(blocks_of(problem.style(), shape));
      if (blocks_.back().patches.empty()) blocks_.pop_back();
    }
    draw_random_tiles();
  }

  const Grid& map() const { return map_; }
  void draw_slice() { slice_.draw(map_, random_); }
  void draw_random_tiles() {
    for (std::size_t site = 0; site < map_.tiles.size(); ++site) {
      std::uint64_t left = random_.below(problem_.domain(site).size());
      problem_.domain(site).for_each([&](Tile tile) {
        if (left-- == 0) map_[site] = tile;
      });
    }
  }

  /// Looks for a map that meets the slice, from the map as it is. After `steps_of_try` steps it begins again
  /// with random tiles.
  Outcome run(std::uint64_t most, std::uint64_t steps_of_try, const StopSignal& stop, std::uint64_t& steps) {
    slice_.look_at(map_);
    for (std::uint64_t step = 0; slice_.unmet() > 0; ++step, ++steps) {
      if (step == most) return Outcome::kGaveUp;
      if (step % steps_of_try == steps_of_try - 1) {
        draw_random_tiles();
        slice_.look_at(map_);
      }
      if (step % 256 == 0 && stop.stopped()) return Outcome::kStopped;
      uniform(random_) < kWalk ? walk() : anneal();
    }
    return Outcome::kFound;
  }

 private:
  /// Mends an unmet factor, as WalkSAT does.
  void walk() {
    const Slice::Scope scope = slice_.random_unmet(random_);
    if (uniform(random_) < kFlip) {
      const Blocks& blocks = blocks_[random_.below(blocks_.size())];
      paste(blocks, scope.anchor, blocks.patches[random_.below(blocks.patches.size())]);
      return;
    }
    std::vector<const Blocks*> covering;
    for (const Blocks& blocks : blocks_) {
      if (covers(blocks.shape, scope.shape)) covering.push_back(&blocks);
    }
    if (covering.empty()) covering.push_back(&blocks_[random_.below(blocks_.size())]);  // B1 covers no pair
    const Blocks& blocks = *covering[random_.below(covering.size())];
    Point anchor = scope.anchor;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const int room = std::abs(blocks.shape.extent[axis] - scope.shape.extent[axis]);
      const int shift = static_cast<int>(random_.below(static_cast<std::uint64_t>(room) + 1));
      anchor[axis] += covers(blocks.shape, scope.shape) ? -shift : shift;
    }
    paste(blocks, anchor, best_patch(blocks, anchor));
  }

  static bool covers(const Size& block, const Size& scope) {
    return block.width() >= scope.width() && block.height() >= scope.height() &&
           block.depth() >= scope.depth();
  }

  /// Tries a random block at a random site, at a fixed temperature.
  void anneal() {
    const Point at = map_.size.point(random_.below(map_.tiles.size()));
    const Blocks& blocks = blocks_[random_.below(blocks_.size())];
    set_sites(blocks, at);
    const std::size_t unmet = slice_.unmet_around(map_, sites_);
    const std::vector<Tile> before = tiles_at_sites();
    write(blocks.patches[random_.below(blocks.patches.size())]);
    const double gain = static_cast<double>(unmet) - static_cast<double>(slice_.unmet_around(map_, sites_));
    if (uniform(random_) < std::exp(gain / kTemperature)) {
      slice_.look_again(map_, sites_);
      return;
    }
    for (std::size_t i = 0; i < sites_.size(); ++i) map_[sites_[i]] = before[i];
  }

  /// Returns the patch of the exemplars that leaves fewest factors unmet; one of them, if there are several.
  const std::vector<Tile>& best_patch(const Blocks& blocks, const Point& anchor) {
    set_sites(blocks, anchor);
    const std::vector<Tile> before = tiles_at_sites();
    std::size_t least = SIZE_MAX, ties = 0, best = 0;
    for (std::size_t patch = 0; patch < blocks.patches.size(); ++patch) {
      write(blocks.patches[patch]);
      const std::size_t unmet = slice_.unmet_around(map_, sites_);
      if (unmet > least) continue;
      ties = unmet < least ? 1 : ties + 1;
      least = unmet;
      if (random_.below(ties) == 0) best = patch;
    }
    for (std::size_t i = 0; i < sites_.size(); ++i) map_[sites_[i]] = before[i];
    return blocks.patches[best];
  }

  void paste(const Blocks& blocks, const Point& anchor, const std::vector<Tile>& patch) {
    set_sites(blocks, anchor);
    write(patch);
    slice_.look_again(map_, sites_);
  }

  /// Sets the sites of a block; those outside of the map are left out.
  void set_sites(const Blocks& blocks, const Point& anchor) {
    sites_.clear();
    places_.clear();
    std::size_t place = 0;
    for_each_point(blocks.shape, [&](const Point& offset) {
      const std::size_t site = problem_.topology().site(anchor, offset);
      if (site != Topology::kNone) {
        sites_.push_back(static_cast<std::uint32_t>(site));
        places_.push_back(place);
      }
      ++place;
    });
  }

  std::vector<Tile> tiles_at_sites() const {
    std::vector<Tile> tiles;
    for (const std::uint32_t site : sites_) tiles.push_back(map_[site]);
    return tiles;
  }

  /// Writes a patch to the sites. Tiles that a site may not have are left out.
  void write(const std::vector<Tile>& patch) {
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      const Tile tile = patch[places_[i]];
      if (problem_.domain(sites_[i]).contains(tile)) map_[sites_[i]] = tile;
    }
  }

  const Problem& problem_;
  Slice slice_;
  RandomStream random_;
  Grid map_;
  std::vector<Blocks> blocks_;
  std::vector<std::uint32_t> sites_;  // of the block at work
  std::vector<std::size_t> places_;   // of those sites in the block
};

}  // namespace

Sample sample_blockss(const Problem& problem, const SamplerOptions& options, std::uint64_t number,
                      const StopSignal& stop) {
  Sample sample;
  BlockSearch search(problem, options.largest_block, mix(options.seed, number));
  const std::uint64_t most = options.effort > 0 ? options.effort : kStepsPerSite * problem.sites() + 10'000;
  const std::uint64_t steps_of_try = options.restart ? kStepsPerTry * problem.sites() : UINT64_MAX;
  for (std::uint64_t each = 0; each <= options.burn_in; ++each) {
    if (each > 0) search.draw_slice();
    if (each > 0 && options.restart) search.draw_random_tiles();
    sample.outcome = search.run(most, steps_of_try, stop, sample.windows);
    if (sample.outcome != Outcome::kFound) return sample;
  }
  sample.map = search.map();
  return sample;
}

}  // namespace solitaire::tiles
