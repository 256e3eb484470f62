// Maps of tiles that programs choose, drawn by --engine tiles.
#include <algorithm>
#include <doctest/doctest.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "engines/tile_maps/map_style.h"
#include "engines/tile_maps/tile_stream.h"
#include "library/known_tile_files.h"
#include "solitaire/names/analyze.h"
#include "tests/support/command.h"
#include "tests/support/text.h"
#include "tests/tiles/enumeration.h"

namespace solitaire {
namespace {

using Json = nlohmann::json;

const char* const kStreets =
    "import \"std/graph.sol\";\nimport \"std/tiles.sol\";\n"
    "g, r, h = \"grass\", \"road\", \"house\";\nstreets = tiles(\"streets.tiles.json\");\n";

/// Tiles without an exemplar, and so without weights, which would take a while to fit: no house is beside a
/// house.
const char* const kTiles =
    R"({"tiles": [{"name": "grass"}, {"name": "road"}, {"name": "house"}], "adjacencies": [
  {"left": ["grass", "road"], "right": ["grass", "road", "house"]}, {"left": ["house"], "right": ["grass", "road"]},
  {"top": ["grass", "road"], "bottom": ["grass", "road", "house"]}, {"top": ["house"], "bottom": ["grass", "road"]}]})";

/// The program of a text, whose files with tiles are in a folder.
Program program_of_text(const std::string& text, const std::filesystem::path& folder) {
  SourceSet sources;
  LoadOptions options;
  options.library_folders = {std::filesystem::path(SOLITAIRE_SOURCE_DIR) / "solitaire"};
  options.tile_files = std::make_shared<api::KnownTileFiles>(folder);
  return load_program_text("map.sol", text, options, sources);
}

/// Runs `solve --engine tiles` and returns the values of the solutions.
std::vector<Json> drawn(const Workplace& place, const std::string& script,
                        std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"solve", place.file("map.sol", script), "--engine", "tiles", "--json",
                                     "-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run_solitaire(arguments);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  std::vector<Json> values;
  for (const std::string& line : lines_of(outcome.out)) values.push_back(Json::parse(line)["value"]);
  return values;
}

std::size_t count_of(const Json& map, const char* tile) {
  std::size_t count = 0;
  for (const Json& row : map) count += static_cast<std::size_t>(std::ranges::count(row, Json(tile)));
  return count;
}

/// Returns how many pieces the tiles of a kind form.
std::size_t pieces_of(Json map, const std::string& tile) {
  std::size_t pieces = 0;
  const std::function<void(std::size_t, std::size_t)> flood = [&](std::size_t y, std::size_t x) {
    if (y >= map.size() || x >= map[0].size() || map[y][x] != tile) return;
    map[y][x] = "seen";
    flood(y + 1, x), flood(y, x + 1), flood(y - 1, x), flood(y, x - 1);
  };
  for (std::size_t y = 0; y < map.size(); ++y) {
    for (std::size_t x = 0; x < map[0].size(); ++x) {
      if (map[y][x] != tile) continue;
      ++pieces;
      flood(y, x);
    }
  }
  return pieces;
}

/// No map has grass in the middle of its first row.
class NoGrassThere : public tiles::GlobalRule {
 public:
  std::uint64_t violation(const tiles::Grid& map) const override { return map[1] == 0 ? 1 : 0; }
  std::string text() const override { return "no grass there"; }
};

}  // namespace

TEST_CASE("engine tiles: drawn maps are as frequent as enumeration says") {
  const Workplace place;
  place.file("streets.tiles.json", kTiles);
  const Program program = program_of_text(
      std::string(kStreets) + "map = tile_map(streets, 2, 2);\nassert(map[0][1] != g);\nreturn map;\n",
      place.path());
  const auto style = style_of_source(Value::string("streets.tiles.json"), program, 0, StopSignal());
  tiles::Problem problem(style, {{{2, 2, 1}}, {}});
  problem.add(std::make_shared<NoGrassThere>());
  tiles::Enumeration all(problem);
  REQUIRE(all.size() > 20);
  TileStream stream(program, {}, TracingOptions());
  for (int draw = 0; draw < 600; ++draw) {
    const auto solution = stream.next();
    REQUIRE(solution);
    tiles::Grid map(problem.size());
    REQUIRE(solution->choices.size() == map.tiles.size());
    for (std::size_t site = 0; site < map.tiles.size(); ++site)
      map[site] = static_cast<tiles::Tile>(solution->choices[site].value.as_int());
    all.draw(map);
  }
  CHECK(all.strangers() == 0);
  CHECK(all.deviations() < 4);
}

TEST_CASE("engine tiles: pins, asserts and other choices hold, and the same seed gives the same maps") {
  const Workplace place;
  place.file("streets.tiles.json", kTiles);
  const std::string script = std::string(kStreets) +
                             "n = range(3, 6);\nmap = tile_map(streets, 8, 6);\n"
                             "assert(count([t == h for row in map for t in row]) == n, \"houses\");\n"
                             "assert(map[0][0] == h);\nreturn map, n;\n";
  const std::vector<std::string> options{"-n", "3", "--pin", "map/site[5][7]=\"road\"", "--seed", "3"};
  const std::vector<Json> values = drawn(place, script, options);
  REQUIRE(values.size() == 3);
  for (const Json& value : values) {
    CHECK(count_of(value[0], "house") == value[1].get<std::size_t>());
    CHECK(value[0][0][0] == "house");
    CHECK(value[0][5][7] == "road");
  }
  CHECK(std::set<Json>(values.begin(), values.end()).size() == 3);
  CHECK(drawn(place, script, options) == values);
}

TEST_CASE("engine tiles: what the library computes of a map follows it") {
  const Workplace place;
  place.file("streets.tiles.json", kTiles);
  const std::string script = std::string(kStreets) +
                             "map = tile_map(streets, 7, 7);\n"
                             "assert(connected(grid_graph(7, 7), is_one_of(map, [r])), \"one network\");\n"
                             "assert(count(is_one_of(map, [r])) >= 8);\nreturn map;\n";
  const std::vector<Json> maps = drawn(place, script, {"-n", "4"});
  REQUIRE(maps.size() == 4);
  for (const Json& map : maps) {
    CHECK(pieces_of(map, "road") == 1);
    CHECK(count_of(map, "road") >= 8);
  }
  CHECK(std::set<Json>(maps.begin(), maps.end()).size() == 4);
}

TEST_CASE("engine tiles: several maps, each with its conditions") {
  const Workplace place;
  place.file("wood.tiles.json", R"({"tiles": [{"name": "T"}, {"name": "."}], "adjacencies": [
    {"left": ["T", "."], "right": ["T", "."]}, {"top": ["T", "."], "bottom": ["T", "."]}]})");
  const std::string script =
      "import \"std/tiles.sol\";\nwood = tiles(\"wood.tiles.json\");\na = tile_map(wood, 5, 4);\nb = "
      "tile_map(wood, "
      "4, 5);\n"
      "assert(a[0][0] != b[0][0]);\nreturn a, b;\n";
  for (const Json& value : drawn(place, script, {"-n", "2"})) CHECK(value[0][0][0] != value[1][0][0]);
}

TEST_CASE("engine tiles: what it does not know is told") {
  const Workplace place;
  place.file("streets.tiles.json", kTiles);
  const auto complaint = [&](const std::string& script, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"solve", place.file("map.sol", script), "--engine", "tiles"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_solitaire(arguments);
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  CHECK(complaint("return range(1, 3);\n").find("the program makes none") != std::string::npos);
  const std::string map = std::string(kStreets) + "map = tile_map(streets, 3, 2);\n";
  CHECK(complaint(map + "prefer(map[0][0] == g);\nreturn map;\n").find("knows no wishes") !=
        std::string::npos);
  CHECK(complaint(map + "return map;\n", {"--all"}).find("there is neither an end") != std::string::npos);
  const Outcome none =
      run_solitaire({"solve", place.file("none.sol", map + "assert(map[0][0] == \"sea\");\nreturn map;\n"),
                     "--engine", "tiles"});
  CHECK(none.status == 1);
}

}  // namespace solitaire
