// Exemplars and adjacencies that count in several orientations.
#include "engines/tiles/request/orientations.h"

#include <doctest/doctest.h>

#include "engines/tiles/request/read_style.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/request/request_file.h"
#include "engines/tiles/tiled/gid_flags.h"
#include "engines/tiles/write/png.h"
#include "tests/tiles/folder.h"

namespace solitaire::tiles {
namespace {

std::shared_ptr<Style> style_of_file(const TestFolder& folder, const std::string& problem) {
  return read_style(read_request(folder.write("p.tiles.json", problem)));
}

TEST_CASE("eight orientations of a tile of Tiled are each other's turned and mirrored images") {
  for (std::uint32_t flags = 0; flags < 8; ++flags) {
    const std::uint32_t gid = 6U | flags << 29U;
    CAPTURE(flags);
    CHECK(turned_gid(turned_gid(turned_gid(turned_gid(gid)))) == gid);
    CHECK(mirrored_gid(mirrored_gid(gid)) == gid);
    CHECK(mirrored_gid(turned_gid(mirrored_gid(turned_gid(gid)))) == gid);
    CHECK(turned_gid(gid) != gid);
    CHECK(mirrored_gid(gid) != gid);
  }
  CHECK(mirrored_gid(6) == (6U | kFlipAcross));
  CHECK(turned_gid(turned_gid(6)) == (6U | kFlipAcross | kFlipDown));
  CHECK(turned_gid(6) == (6U | kFlipAcross | kFlipDiagonal));
}

TEST_CASE("a turned exemplar teaches pairs of turned tiles, and holes where none is known") {
  const TestFolder folder("solitaire-orientations-");
  folder.write("e.txt", "ab\n.c\n");
  const std::string tiles = R"("tiles": [{"name": "a", "char": "a", "turned": "b", "mirrored": "a"},
    {"name": "b", "char": "b", "turned": "a", "mirrored": "b"}, {"name": "c", "char": "c"},
    {"name": "dot", "char": ".", "symmetry": "X"}], "exemplars": ["e.txt"])";
  const auto allowed = [](const Style& style, std::size_t axis, const char* first, const char* second) {
    return style.pairs.front().allowed(axis, *style.tileset.find(first), *style.tileset.find(second));
  };
  const auto plain = style_of_file(folder, "{" + tiles + "}");
  CHECK(allowed(*plain, 0, "a", "b"));
  CHECK_FALSE(allowed(*plain, 1, "b", "a"));

  const auto turned = style_of_file(folder, "{" + tiles + R"(, "symmetry": "4"})");
  // A quarter turn: a over b with b for a and a for b, then dot left of b.
  CHECK(allowed(*turned, 1, "b", "a"));
  CHECK(allowed(*turned, 0, "dot", "b"));
  CHECK(allowed(*turned, 0, "b", "a"));    // by a half turn
  CHECK(allowed(*turned, 0, "dot", "c"));  // as it stands in the exemplar
  CHECK_FALSE(allowed(*turned, 0, "c", "dot"));
  CHECK(turned->exemplars.size() == 4);

  const auto mirrored = style_of_file(folder, "{" + tiles + R"(, "symmetry": "mirror"})");
  CHECK(allowed(*mirrored, 0, "b", "a"));
  CHECK_FALSE(allowed(*mirrored, 1, "b", "a"));

  CHECK_THROWS_AS(style_of_file(folder, R"({"exemplars": ["e.txt"], "symmetry": "8"})"), RequestError);
}

TEST_CASE("squares of a picture turn into those that look so") {
  const TestFolder folder("solitaire-orientations-");
  Picture picture(4, 2, {255, 255, 255, 255});
  picture.at(0, 0) = picture.at(1, 0) = {0, 0, 0, 255};  // a bar on top, then a bar at the right
  picture.at(3, 0) = picture.at(3, 1) = {0, 0, 0, 255};
  folder.write("e.png", write_png(picture));
  const auto style = style_of_file(folder, R"({"exemplars": ["e.png"], "tile": 2, "symmetry": "4"})");
  REQUIRE(style->tileset.size() == 2);
  // After a quarter turn the first tile is the second one, and the second one is unknown. After a half turn
  // both are.
  REQUIRE(style->exemplars.size() == 2);
  CHECK(style->exemplars[1].grid.tiles == std::vector<Tile>{1, kHole});
  CHECK(style->exemplars[1].grid.size == Size{{1, 2, 1}});
}

TEST_CASE("adjacencies turn with their tiles") {
  const TestFolder folder("solitaire-orientations-");
  const auto style =
      style_of_file(folder, R"({"tiles": [{"name": "bend", "symmetry": "L"}, {"name": "x", "symmetry": "X"}],
    "adjacencies": [{"left": ["bend"], "right": ["x"]}], "symmetry": "4"})");
  const auto allowed = [&](std::size_t axis, const char* first, const char* second) {
    return style->pairs.front().allowed(axis, *style->tileset.find(first), *style->tileset.find(second));
  };
  CHECK(allowed(0, "bend", "x"));
  CHECK(allowed(1, "bend!90", "x"));
  CHECK(allowed(0, "x", "bend!180"));
  CHECK(allowed(1, "x", "bend!270"));
  CHECK_FALSE(allowed(0, "bend!90", "x"));
  CHECK_FALSE(allowed(1, "x", "bend"));
}

TEST_CASE("borders may leave sides out, mean what is inside, and forbid") {
  const TestFolder folder("solitaire-orientations-");
  folder.write("e.txt", "ab\nba\naa\nbb\n");
  const Request request =
      read_request(folder.write("p.tiles.json", R"({"exemplars": ["e.txt"], "size": [4, 3], "borders": [
    {"side": "all", "except": ["top"], "tiles": ["a"]}, {"side": ["left", "right"], "inside": true, "forbid": true, "tiles": ["b"]}]})"));
  CHECK(request.borders[0].except == std::vector<std::string>{"top"});
  CHECK(request.borders[1].sides.size() == 2);
  CHECK(request.borders[1].inside);
  CHECK(request.borders[1].forbidden);
}

}  // namespace
}  // namespace solitaire::tiles
