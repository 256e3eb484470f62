#include <doctest/doctest.h>

#include "engines/tiles/check/check.h"
#include "engines/tiles/chunks/endless_map.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

EndlessMap endless(const char* exemplar, std::uint64_t seed, std::shared_ptr<Style>& style) {
  style = style_of(exemplar);
  add_step_shape(*style, {{2, 2, 1}}, 0.5);
  EndlessMap map(style, seed);
  REQUIRE(map.prepare(StopSignal()) == Outcome::kFound);
  return map;
}

EndlessMap streets(std::uint64_t seed, std::shared_ptr<Style>& style) {
  return endless(kStreets, seed, style);
}

/// Houses in a garden. Streets that have no end stay where they are; houses come and go.
const char* const kGarden = "..#..\n.##.#\n#..#.\n.#.##\n";

TEST_CASE("chunks: a part of the plane is the same whichever region it is asked for with") {
  std::shared_ptr<Style> style;
  const EndlessMap map = streets(3, style);
  const FarPoint from{-7, 11};
  const Grid whole = map.region(from, {{30, 20, 1}}, StopSignal());
  struct Box {
    int x, y, width, height;
  };
  for (const Box& box : {Box{0, 0, 15, 20}, {15, 0, 15, 20}, {4, 7, 1, 1}, {9, 3, 12, 5}}) {
    const Grid part =
        map.region({from[0] + box.x, from[1] + box.y}, {{box.width, box.height, 1}}, StopSignal());
    for_each_point(part.size, [&](const Point& at) {
      REQUIRE(part.at(at) == whole.at({at[0] + box.x, at[1] + box.y, 0}));
    });
  }
  CHECK(find_faults(Problem(style, {whole.size, {}}), whole).empty());
}

TEST_CASE("chunks: far from the origin and on both sides of it the pairs are those of the exemplar") {
  std::shared_ptr<Style> style;
  const EndlessMap map = streets(4, style);
  for (const FarPoint from : {FarPoint{-20, -20}, {kFarthest - 40, -kFarthest}, {1'000'000'007, 3}}) {
    const Grid part = map.region(from, {{40, 40, 1}}, StopSignal());
    CHECK(find_faults(Problem(style, {part.size, {}}), part).empty());
  }
  CHECK_THROWS_AS(map.region({kFarthest + 1, 0}, {{4, 4, 1}}, StopSignal()), std::length_error);
  CHECK_THROWS_AS(map.region({0, 0}, {{4000, 4000, 1}}, StopSignal()), std::length_error);
}

TEST_CASE("chunks: the seed decides, and nothing of the periodic map is left to see") {
  std::shared_ptr<Style> style;
  const EndlessMap one = endless(kGarden, 5, style), again = endless(kGarden, 5, style),
                   other = endless(kGarden, 6, style);
  const Size size{{60, 20, 1}};
  const Grid map = one.region({0, 0}, size, StopSignal());
  CHECK(map == again.region({0, 0}, size, StopSignal()));
  CHECK_FALSE(map == other.region({0, 0}, size, StopSignal()));
  const auto alike = [&](int shift) {
    double same = 0;
    const Size part{{20, size.height(), 1}};
    for_each_point(part, [&](const Point& at) {
      same += map.at(at) == map.at({at[0] + shift, at[1], 0}) ? 1 : 0;
    });
    return same / static_cast<double>(part.volume());
  };
  double usual = 0;
  for (const int shift : {17, 19, 22, 26, 33, 39}) usual += alike(shift) / 6;
  for (const int period : {20, 24, 30, 40}) CHECK(alike(period) < usual + 0.15);
}

TEST_CASE("chunks: a wish to stop is heard") {
  std::shared_ptr<Style> style;
  const EndlessMap map = streets(7, style);
  StopSignal stop;
  stop.request();
  CHECK_THROWS_AS(map.region({0, 0}, {{40, 40, 1}}, stop), Interrupted);
}

}  // namespace
}  // namespace solitaire::tiles
