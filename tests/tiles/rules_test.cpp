#include <algorithm>
#include <doctest/doctest.h>
#include <initializer_list>
#include <set>

#include "base/random.h"
#include "engines/tiles/model/mirror.h"
#include "engines/tiles/rules/components.h"
#include "engines/tiles/rules/connected.h"
#include "engines/tiles/rules/distance.h"
#include "engines/tiles/rules/longest_run.h"
#include "engines/tiles/rules/loops.h"
#include "engines/tiles/rules/path.h"
#include "engines/tiles/rules/tile_count.h"
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

/// Returns how many networks the passable sites form, without one site or the link between two.
std::size_t networks_without(const Topology& topology, const std::vector<Sides>& open, const Grid& map,
                             std::size_t site, std::size_t from = SIZE_MAX, std::size_t to = SIZE_MAX) {
  Components components(map.tiles.size());
  std::size_t count = 0;
  for (std::size_t each = 0; each < map.tiles.size(); ++each) {
    if (each == site || open[map[each]] == 0) continue;
    ++count;
    for_each_linked(topology, open, map, each, [&](std::size_t next) {
      const bool is_left_out = (each == from && next == to) || (each == to && next == from);
      if (next < each && next != site && !is_left_out && components.join(each, next)) --count;
    });
  }
  return count;
}

TEST_CASE("networks hang on the sites and links without which they fall apart") {
  const auto style = style_of("#_|.\n");
  const std::vector<Sides> open{0, kAllSides, static_cast<Sides>(side(1, 1) | side(1, -1)),
                                static_cast<Sides>(side(0, 1) | side(0, -1) | side(1, -1))};
  const auto violation = [&](const char* text) {
    const Grid map = read_text("m", text, style->tileset, false);
    return Loops({map.size, {}}, open, "").violation(map);
  };
  CHECK(violation("__\n__\n") == 0);
  CHECK(violation("_#_\n") == 0);            // each of them alone
  CHECK(violation("#__\n") == 1);            // the link
  CHECK(violation("___\n") == 3);            // both links, and the site between
  CHECK(violation("__#\n___\n#__\n") == 1);  // two loops that share a site
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream random(seed, Purpose::kTiles, 0);
    const Topology topology{
        {{3 + static_cast<int>(random.below(5)), 3 + static_cast<int>(random.below(4)), 1}},
        {seed % 2 == 1, seed % 3 == 2, false}};
    Grid map(topology.size);
    for (Tile& tile : map.tiles) tile = static_cast<Tile>(random.below(5) % 4);
    std::uint64_t expected = 0;
    const std::size_t all = networks_without(topology, open, map, SIZE_MAX);
    for (std::size_t site = 0; site < map.tiles.size(); ++site) {
      if (open[map[site]] == 0) continue;
      bool is_alone = true;
      for_each_linked(topology, open, map, site, [&](std::size_t next) {
        is_alone = false;
        if (next < site && networks_without(topology, open, map, SIZE_MAX, site, next) > all) ++expected;
      });
      if (!is_alone && networks_without(topology, open, map, site) > all) ++expected;
    }
    REQUIRE(Loops(topology, open, "").violation(map) == expected);
  }
}

TEST_CASE("what follows a map through changes finds what the whole map shows") {
  const auto style = style_of("#_|.\n");
  const std::vector<Sides> open{0, kAllSides, static_cast<Sides>(side(1, 1) | side(1, -1)),
                                static_cast<Sides>(side(0, 1) | side(0, -1) | side(1, -1))};
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    RandomStream random(seed, Purpose::kTiles, 0);
    const auto below = [&](int limit) {
      return static_cast<int>(random.below(static_cast<std::uint64_t>(limit)));
    };
    const Topology topology{{{2 + below(11), 1 + below(9), 1}}, {seed % 2 == 1, seed % 3 == 2, false}};
    Grid map(topology.size);
    const int rock = below(5);  // the more of it, the more networks
    const auto tile = [&] { return static_cast<Tile>(std::max(0, below(4 + rock) - rock)); };
    for (Tile& each : map.tiles) each = tile();
    const Connected connected(topology, open, "");
    const TileCount count(TileMask::of(1) | TileMask::of(3), 9, 14, "");
    const LongestRun run(TileMask::of(1), {0, 1}, 2, "");
    for (const GlobalRule* rule : std::initializer_list<const GlobalRule*>{&connected, &count, &run}) {
      const auto watch = rule->watch(map);
      for (int change = 0; change < 150; ++change) {
        std::vector<std::uint32_t> sites;
        std::vector<Tile> before;
        const Point from{below(topology.size.width()), below(topology.size.height()), 0};
        for (int y = from[1]; y < std::min(from[1] + 3, topology.size.height()); ++y) {
          for (int x = from[0]; x < std::min(from[0] + 4, topology.size.width()); ++x) {
            sites.push_back(static_cast<std::uint32_t>(topology.size.site({x, y, 0})));
            before.push_back(map[sites.back()]);
            if (random.below(3) > 0) map[sites.back()] = tile();
          }
        }
        REQUIRE(watch->after(map, {sites, before}) == rule->violation(map));
        if (random.below(2) == 0) {
          watch->keep();
        } else {
          for (std::size_t i = 0; i < sites.size(); ++i) map[sites[i]] = before[i];
        }
      }
    }
  }
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
