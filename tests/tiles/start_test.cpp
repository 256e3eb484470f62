#include "engines/tiles/start/start.h"

#include <algorithm>
#include <doctest/doctest.h>

#include "engines/tiles/check/check.h"
#include "engines/tiles/count/count.h"
#include "engines/tiles/explain/explain.h"
#include "tests/tiles/enumeration.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

/// A problem whose sites have random pins.
Problem with_random_pins(const std::shared_ptr<const Style>& style, const Topology& topology,
                         RandomStream& random, std::uint64_t pins) {
  Problem problem(style, topology);
  for (std::uint64_t pin = 0; pin < pins; ++pin) {
    const auto site = static_cast<std::uint32_t>(random.below(problem.sites()));
    const auto tile = static_cast<Tile>(random.below(style->tileset.size()));
    problem.add({"pin " + std::to_string(pin), {site}, TileMask::of(tile)});
  }
  return problem;
}

TEST_CASE("a start is found where enumeration finds a map, and proved not to be elsewhere") {
  const StopSignal stop;
  const std::shared_ptr<Style> style = style_of(kStreets);
  std::size_t with_map = 0, without = 0;
  for (std::uint64_t number = 0; number < 150; ++number) {
    CAPTURE(number);
    RandomStream random(number, Purpose::kTiles, 0);
    Topology topology = flat(3, 3);
    topology.periodic[0] = number % 3 == 0;
    const Problem problem = with_random_pins(style, topology, random, 2 + number % 3);
    const bool any = Enumeration(problem).size() > 0;
    Grid map;
    const Outcome outcome = make_start(problem, consistent_domains(problem), random, stop, map);
    CHECK(outcome == (any ? Outcome::kFound : Outcome::kNone));
    if (any) CHECK(find_faults(problem, map).empty());
    ++(any ? with_map : without);
  }
  CHECK(with_map > 20);
  CHECK(without > 20);
}

TEST_CASE("large starts hold, over many blocks and with pins") {
  const StopSignal stop;
  const std::shared_ptr<Style> style = style_of(kStreets);
  const auto crossroad = style->tileset.find("+");
  REQUIRE(crossroad);
  Topology topology = flat(75, 61);
  topology.periodic = {true, true, false};
  Problem problem(style, topology);
  for (int y = 10; y < 61; y += 20) {
    for (int x = 10; x < 75; x += 20) {
      const auto site = static_cast<std::uint32_t>(problem.size().site({x, y, 0}));
      problem.add({"a crossroad", {site}, TileMask::of(*crossroad)});
    }
  }
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    RandomStream random(seed, Purpose::kTiles, 0);
    Grid map;
    REQUIRE(make_start(problem, consistent_domains(problem), random, stop, map) == Outcome::kFound);
    CHECK(find_faults(problem, map).empty());
  }
}

TEST_CASE("the count of maps is that of enumeration") {
  const StopSignal stop;
  const std::shared_ptr<Style> style = style_of(kStreets);
  for (std::uint64_t number = 0; number < 12; ++number) {
    RandomStream random(number, Purpose::kTiles, 0);
    const Problem problem = with_random_pins(style, flat(number % 2 == 0 ? 3 : 4, 3), random, number % 3);
    CHECK(count_maps(problem, stop) == std::to_string(Enumeration(problem).size()));
  }
}

TEST_CASE("an explanation contradicts itself as a whole, and none of its parts does") {
  const StopSignal stop;
  const std::shared_ptr<Style> style = style_of(kStreets);
  std::size_t explained = 0;
  for (std::uint64_t number = 0; number < 60; ++number) {
    CAPTURE(number);
    RandomStream random(number, Purpose::kTiles, 0);
    const Problem problem = with_random_pins(style, flat(3, 3), random, 5);
    const auto reason = explain_no_map(problem, stop);
    CHECK(reason.has_value() == (Enumeration(problem).size() == 0));
    if (!reason) continue;
    ++explained;
    const auto maps_without = [&](const std::string& left_out) {
      Problem part(style, flat(3, 3));
      for (const SiteRule& rule : problem.site_rules()) {
        const bool named = std::ranges::find(reason->rules, rule.text) != reason->rules.end();
        if (named && rule.text != left_out) part.add(rule);
      }
      return Enumeration(part).size();
    };
    CHECK(maps_without("") == 0);
    for (const std::string& rule : reason->rules) CHECK(maps_without(rule) > 0);
  }
  CHECK(explained > 10);
}

}  // namespace
}  // namespace solitaire::tiles
