#include "engines/tiles/check/check.h"

#include <doctest/doctest.h>

#include "engines/tiles/rules/tile_count.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

TEST_CASE("the checker names whatever is wrong with a map") {
  const std::shared_ptr<Style> style = style_of("aab\nccb\n");
  const auto faults = [&](const Problem& problem, const char* text) {
    return find_faults(problem, read_text("map", text, style->tileset, false));
  };
  const Problem plain(style, flat(3, 2));
  CHECK(faults(plain, "aab\nccb\n").empty());
  CHECK(faults(plain, "aba\nccb\n") ==
        std::vector<std::string>{"(1,0) has 'b' left of 'a', which no exemplar has",
                                 "(1,0) has 'b' above 'c', which no exemplar has",
                                 "(2,0) has 'a' above 'b', which no exemplar has"});
  CHECK(faults(plain, "aa\ncc\n") == std::vector<std::string>{"the map has another size"});

  Problem pinned(style, flat(3, 2));
  pinned.add({"(0,0) is pinned to 'b'", {0}, TileMask::of(*style->tileset.find("b"))});
  CHECK(faults(pinned, "aab\nccb\n") ==
        std::vector<std::string>{"(0,0) has 'a', but (0,0) is pinned to 'b'"});

  Problem counted(style, flat(3, 2));
  counted.add(std::make_shared<TileCount>(TileMask::of(0), 3, 9, "there are 3 to 9 of 'a'"));
  CHECK(faults(counted, "aab\nccb\n") == std::vector<std::string>{"broken: there are 3 to 9 of 'a'"});

  Topology ring = flat(3, 2);
  ring.periodic[0] = true;
  CHECK(faults(Problem(style, ring), "aab\nccb\n") ==
        std::vector<std::string>{"(2,0) has 'b' left of 'a', which no exemplar has",
                                 "(2,1) has 'b' left of 'c', which no exemplar has"});
}

TEST_CASE("what a negative exemplar has is a fault") {
  const std::shared_ptr<Style> style = style_of("aabba\n");
  Exemplar never;
  never.grid = read_text("never", "ba\n", style->tileset, false);
  never.negative = true;
  style->exemplars.push_back(never);
  learn_pairs(*style);
  const Problem problem(style, flat(4, 1));
  CHECK(find_faults(problem, read_text("map", "aabb\n", style->tileset, false)).empty());
  CHECK(find_faults(problem, read_text("map", "abba\n", style->tileset, false)).size() == 1);
}

}  // namespace
}  // namespace solitaire::tiles
