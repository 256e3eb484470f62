#include "engines/tiles/sample/refill.h"

#include <doctest/doctest.h>

#include "engines/tiles/check/check.h"
#include "tests/tiles/enumeration.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

std::shared_ptr<Style> streets_of_squares() {
  const std::shared_ptr<Style> style = style_of(kStreets);
  add_step_shape(*style, {{2, 2, 1}}, 0.5);
  return style;
}

TEST_CASE("a part of a map is made anew, and the rest stays") {
  const Problem problem(streets_of_squares(), flat(30, 20));
  const Grid before = draw_sample(problem, consistent_domains(problem), {}, 1, StopSignal()).map;
  Grid map = before;
  const Box box{{5, 4, 0}, {17, 13, 1}};
  SamplerOptions options;
  options.seed = 5;
  REQUIRE(refill(problem, box, options, StopSignal(), map) == Outcome::kFound);
  CHECK(find_faults(problem, map).empty());
  std::size_t changed = 0;
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    if (map[site] == before[site]) continue;
    ++changed;
    CHECK(box.contains(map.size.point(site)));
  }
  CHECK(changed > 20);
}

TEST_CASE("parts come as often as the distribution of whole maps says, given the rest") {
  const std::shared_ptr<Style> style = streets_of_squares();
  const Problem problem(style, flat(6, 5));
  const Grid before = draw_sample(problem, consistent_domains(problem), {}, 1, StopSignal()).map;
  const Box box{{2, 1, 0}, {5, 3, 1}};
  Problem given_rest(style, flat(6, 5));
  for (std::uint32_t site = 0; site < before.tiles.size(); ++site) {
    if (!box.contains(before.size.point(site))) given_rest.add({"", {site}, TileMask::of(before[site])});
  }
  Enumeration all(given_rest);
  REQUIRE(all.size() > 5);
  SamplerOptions options;
  options.anneal = 4;
  options.sweeps = 8;
  for (options.seed = 0; options.seed < 1000; ++options.seed) {
    Grid map = before;
    REQUIRE(refill(problem, box, options, StopSignal(), map) == Outcome::kFound);
    all.draw(map);
  }
  CHECK(all.strangers() == 0);
  CHECK(all.chi_squared() < 2);
}

}  // namespace
}  // namespace solitaire::tiles
