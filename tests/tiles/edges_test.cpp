#include <doctest/doctest.h>
#include <set>

#include "engines/tiles/check/check.h"
#include "engines/tiles/learn/edge_pairs.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/request/tile_variants.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

/// A bend from the right to the bottom, with a mark in the lower right corner of its icon.
TileKind bend() {
  TileKind kind;
  kind.name = "bend";
  kind.edges = {"road", "grass", "a|b", "grass", "", ""};
  kind.icon = Picture(2, 2);
  kind.icon.at(1, 1) = {255, 0, 0, 255};
  return kind;
}

TEST_CASE("labels of sides meet when one is the other read backwards") {
  CHECK(labels_meet("road", "road"));
  CHECK(labels_meet("a|b", "b|a"));
  CHECK(labels_meet("a|b|a", "a|b|a"));
  CHECK_FALSE(labels_meet("a|b", "a|b"));
  CHECK_FALSE(labels_meet("", ""));
}

TEST_CASE("a tile has as many images as its symmetry says, and turns clockwise") {
  const std::pair<const char*, std::size_t> kCounts[] = {{"", 1},  {"X", 1}, {"I", 2}, {"\\", 2},
                                                         {"T", 4}, {"L", 4}, {"F", 8}};
  for (const auto& [symmetry, count] : kCounts) CHECK(variants_of(bend(), symmetry).size() == count);
  CHECK_THROWS_AS(variants_of(bend(), "Q"), RequestError);
  const std::vector<TileKind> all = variants_of(bend(), "F");
  CHECK(all[1].name == "bend!90");
  CHECK(all[1].edges == std::array<std::string, 6>{"grass", "a|b", "road", "grass", "", ""});
  CHECK(all[1].icon.at(0, 1)[0] == 255);  // the mark is at the lower left
  CHECK(all[4].name == "bend!x");
  CHECK(all[4].edges == std::array<std::string, 6>{"grass", "road", "b|a", "grass", "", ""});
  CHECK(all[4].icon.at(0, 1)[0] == 255);
  std::set<std::array<std::string, 6>> different;
  for (const TileKind& each : all) different.insert(each.edges);
  CHECK(different.size() == 8);
}

TEST_CASE("tiles with labelled sides need no exemplar, and the checker sees sides that do not meet") {
  const auto style = std::make_shared<Style>();
  for (const TileKind& kind : variants_of(bend(), "L")) style->tileset.add(kind);
  learn_pairs(*style);
  // A bend's bottom, a|b, meets none: its own turned images have a|b as well.
  const Tile across = 0;
  CHECK_FALSE(style->pairs[0].allowed(1, across, *style->tileset.find("bend!180")));
  CHECK(style->pairs[0].allowed(0, across, *style->tileset.find("bend!270")) ==
        labels_meet("road", style->tileset[*style->tileset.find("bend!270")].edges[1]));
  const Problem problem(style, flat(2, 1));
  std::size_t kept = 0;
  for (Tile left = 0; left < 4; ++left) {
    for (Tile right = 0; right < 4; ++right) {
      Grid map(problem.size());
      map[0] = left;
      map[1] = right;
      const bool keeps = find_faults(problem, map).empty();
      CHECK(keeps == style->pairs[0].allowed(0, left, right));
      kept += keeps ? 1 : 0;
    }
  }
  CHECK(kept == 5);  // the right sides are road, grass, grass, a|b; the left ones grass, a|b, road, grass
}

}  // namespace
}  // namespace solitaire::tiles
