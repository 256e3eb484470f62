// Weights that make up for what holds of all maps.
#include "engines/tiles/learn/fit.h"

#include <cmath>
#include <doctest/doctest.h>

#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

/// Returns by how much a `b` is worth more than an `a`, after a fit on rows of 40 tiles under rules.
double worth_of_b(const std::function<void(Problem&)>& add_rules) {
  const auto style = style_of("aabab\n");
  const Size single{{1, 1, 1}};
  fit_weights(*style, {&single, 1}, 7, StopSignal(), add_rules);
  const auto worth = [&](const char* tile) {
    const Tile number = style->tileset.find(tile).value();
    return style->shapes.front().log_weight(1, style->shapes.front().patches.find(number));
  };
  return worth("b") - worth("a");
}

TEST_CASE("weights make up for rules about sites, and are as without them where no map keeps these") {
  const auto every_second_is_a = [](Problem& problem) {
    SiteRule rule{"every second", {}, TileMask::of(problem.style().tileset.find("a").value())};
    for (std::uint32_t site = 0; site < problem.sites(); site += 2) rule.sites.push_back(site);
    problem.add(rule);
  };
  const double free = worth_of_b({}), ruled = worth_of_b(every_second_is_a);
  // Two of five tiles are b: with every second one fixed, four of five of the others have to be.
  CHECK(ruled == doctest::Approx(std::log(4.0)).epsilon(0.25));
  CHECK(std::abs(ruled - free) > 0.1);
  const auto nothing_fits = [](Problem& problem) { problem.add({"nothing", {0}, TileMask()}); };
  CHECK(worth_of_b(nothing_fits) == free);
}

}  // namespace
}  // namespace solitaire::tiles
