#include <doctest/doctest.h>
#include <set>

#include "engines/tiles/model/mirror.h"
#include "engines/tiles/rules/distance.h"
#include "engines/tiles/rules/longest_run.h"
#include "engines/tiles/rules/path.h"
#include "engines/tiles/sample/sampler.h"
#include "tests/tiles/drawn_maps.h"
#include "tests/tiles/enumeration.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

Tile tile_named(const Style& style, const std::string& name) { return style.tileset.find(name).value(); }

TEST_CASE("a run has as many tiles too many as it is longer than it may be") {
  const auto style = style_of("#.\n.#\n");
  const auto violation = [&](const char* text, std::vector<std::size_t> axes, std::uint64_t most) {
    const LongestRun rule(TileMask::of(tile_named(*style, "#")), std::move(axes), most, "");
    return rule.violation(read_text("m", text, style->tileset, false));
  };
  CHECK(violation("###.##\n", {0}, 3) == 0);
  CHECK(violation("###.##\n", {0}, 1) == 3);
  CHECK(violation("###.##\n", {1}, 1) == 0);
  CHECK(violation("##\n##\n##\n", {0, 1, 2}, 2) == 2);
}

TEST_CASE("tiles that are too near are counted in pairs, around rings too") {
  const auto style = style_of("#.\n.#\n");
  Topology ring = flat(6, 1);
  ring.periodic[0] = true;
  const Grid map = read_text("m", "#..#.#\n", style->tileset, false);
  const TileMask houses = TileMask::of(tile_named(*style, "#"));
  CHECK(Distance(flat(6, 1), houses, 3, "").violation(map) == 1);
  CHECK(Distance(flat(6, 1), houses, 2, "").violation(map) == 0);
  CHECK(Distance(ring, houses, 3, "").violation(map) == 2);
}

TEST_CASE("a path costs a step for each place where the way is closed") {
  const auto style = style_of("_.|\n._|\n");
  std::vector<Sides> open(style->tileset.size());
  open[tile_named(*style, "_")] = kAllSides;
  open[tile_named(*style, "|")] = static_cast<Sides>(side(1, 1) | side(1, -1));
  const auto violation = [&](const char* text, const Point& to) {
    const Grid map = read_text("m", text, style->tileset, false);
    return Path({map.size, {}}, open, 0, map.size.site(to), "").violation(map);
  };
  CHECK(violation("____\n....\n", {3, 0, 0}) == 0);
  CHECK(violation("_._.\n____\n", {2, 0, 0}) == 0);
  CHECK(violation("_.__\n....\n", {3, 0, 0}) == 2);
  CHECK(violation("_|__\n....\n", {3, 0, 0}) == 2);  // the bar is open up and down only
  CHECK(violation("_\n|\n_\n", {0, 2, 0}) == 0);
}

TEST_CASE("maps with a path, without long runs and with distances come as often as enumeration says") {
  const auto style = style_of(kStreets);
  add_step_shape(*style, {{2, 2, 1}}, 0.5);
  Problem problem(style, flat(3, 2));
  std::vector<Sides> open(style->tileset.size(), kAllSides);
  open[tile_named(*style, "#")] = 0;
  problem.add(std::make_shared<Path>(problem.topology(), open, 0, 5, "a path"));
  problem.add(std::make_shared<LongestRun>(TileMask::of(tile_named(*style, ".")), std::vector<std::size_t>{0},
                                           2, "grass"));
  problem.add(
      std::make_shared<Distance>(problem.topology(), TileMask::of(tile_named(*style, "#")), 2, "houses"));
  check_drawn_maps(problem);
}

TEST_CASE("halves unfold to exactly the maps that are their own mirror images") {
  const auto style = style_of("..<>..\n.<>.=.\n.=..<>\n<>.<>.\n..=...\n.<>.=.\n");
  std::vector<Tile> partners{0, 1, 2, 3};
  std::swap(partners[tile_named(*style, "<")], partners[tile_named(*style, ">")]);
  for (const int width : {4, 5}) {
    CAPTURE(width);
    Problem whole(style, flat(width, 2));
    whole.add({"a pin", {0}, TileMask::of(tile_named(*style, "<")) | TileMask::of(tile_named(*style, "."))});
    const Mirror mirror(whole, 0, partners);
    std::set<std::vector<Tile>> mirrored, unfolded;
    const Enumeration of_whole(whole), of_half(mirror.half());
    for (const auto& [bytes, probability] : of_whole.probability()) {
      const std::vector<Tile> tiles(bytes.begin(), bytes.end());
      bool same = true;
      for (std::size_t site = 0; site < tiles.size(); ++site) {
        const Point at = whole.size().point(site);
        same = same && tiles[whole.size().site({width - 1 - at[0], at[1], 0})] == partners[tiles[site]];
      }
      if (same) mirrored.insert(tiles);
    }
    for (const auto& [bytes, probability] : of_half.probability()) {
      Grid half(mirror.half().size());
      half.tiles.assign(bytes.begin(), bytes.end());
      unfolded.insert(mirror.unfold(half).tiles);
    }
    CHECK(mirrored.size() > 3);
    CHECK(unfolded == mirrored);
  }
}

}  // namespace
}  // namespace solitaire::tiles
