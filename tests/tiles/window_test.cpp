#include <doctest/doctest.h>

#include "engines/tiles/sample/frontier.h"
#include "engines/tiles/sample/sweep.h"
#include "engines/tiles/sample/tile_classes.h"
#include "engines/tiles/start/start.h"
#include "tests/tiles/enumeration.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

/// How a chain of windows is run against the list of all maps.
struct ChainOptions {
  std::size_t draws = 20'000;
  bool boxes = false;
  std::uint64_t thinning = 6;  // sweeps between two draws
};

/// Runs a chain for `sampled` and compares it with the distribution of `target`.
double chain_chi_squared(const Problem& sampled, const Problem& target, const ChainOptions& options) {
  Enumeration all(target);
  REQUIRE(all.size() > 20);
  const StopSignal stop;
  RandomStream random(7, Purpose::kTiles, 0);
  Grid map;
  REQUIRE(make_start(sampled, consistent_domains(sampled), random, stop, map) == Outcome::kFound);
  const SweepPlan plan(sampled);
  Frontier frontier(sampled);
  Weights weights(sampled.style());
  std::uint64_t sweep = 0;
  bool all_redrawn = true;
  for (std::size_t draw = 0; draw < options.draws; ++draw) {
    for (std::uint64_t each = 0; each < options.thinning; ++each, ++sweep) {
      const auto windows = options.boxes ? plan.boxes(2, 2, sweep, random) : plan.bands(sweep, random);
      for (const auto& window : windows)
        all_redrawn = frontier.redraw(map, window, weights, random) == 0 && all_redrawn;
    }
    all.draw(map);
  }
  CHECK(all_redrawn);
  CHECK(all.strangers() == 0);
  return all.chi_squared();
}

std::shared_ptr<Style> soft_streets(double epsilon = 0.5) {
  const std::shared_ptr<Style> style = style_of(kStreets);
  add_step_shape(*style, {{2, 2, 1}}, epsilon);
  add_step_shape(*style, {{3, 1, 1}}, epsilon);
  return style;
}

TEST_CASE("windows draw the maps that enumeration lists, each as often as its weight says (slow)") {
  const Problem streets(soft_streets(), flat(3, 2));
  const double ratio = chain_chi_squared(streets, streets, {});
  CHECK(ratio > 0.7);
  CHECK(ratio < 1.3);
}

TEST_CASE("boxes of sites are drawn as exactly as bands are (slow)") {
  const Problem streets(soft_streets(), flat(3, 3));
  ChainOptions options;
  options.boxes = true;
  options.thinning = 12;
  CHECK(chain_chi_squared(streets, streets, options) < 1.3);
}

TEST_CASE("tiles are the same on sides beside which the same tiles may stand") {
  const std::shared_ptr<Style> style = style_of(kStreets);
  TileClasses classes(*style);
  const Tile* const right = classes.of(side(0, 1));
  REQUIRE(right != nullptr);
  const auto house = *style->tileset.find("#"), park = *style->tileset.find("."),
             road = *style->tileset.find("|");
  CHECK(right[house] == right[park]);
  CHECK(right[house] != right[road]);
  CHECK(classes.count(side(0, 1)) == 4);
  CHECK(classes.of(side(1, 1)) == nullptr);
  CHECK(classes.of(side(0, 1) | side(1, 1)) == nullptr);
}

TEST_CASE("windows are drawn exactly where they forget what later tiles need not know (slow)") {
  const std::shared_ptr<Style> style = style_of(kStreets);
  add_step_shape(*style, {{1, 1, 1}}, 0.5);
  std::vector<double>& weights = style->shapes.front().log_weights.front();
  for (std::size_t patch = 1; patch < weights.size(); ++patch)
    weights[patch] = 0.3 * static_cast<double>(patch);
  const Problem problem(style, flat(4, 3));
  ChainOptions options;
  options.thinning = 12;
  for (const bool boxes : {false, true}) {
    options.boxes = boxes;
    const double ratio = chain_chi_squared(problem, problem, options);
    CHECK(ratio > 0.7);
    CHECK(ratio < 1.3);
  }
}

TEST_CASE("a sampler with other weights is found out") {
  const Problem streets(soft_streets(), flat(3, 2)), wrong(soft_streets(0.7), flat(3, 2));
  CHECK(chain_chi_squared(wrong, streets, {}) > 1.3);
}

}  // namespace
}  // namespace solitaire::tiles
