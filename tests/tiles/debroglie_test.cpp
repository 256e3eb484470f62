// Configurations of DeBroglie, in the forms that its documentation has.
#include "engines/tiles/request/debroglie.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <set>

#include "base/file_error.h"
#include "engines/tiles/job/job.h"
#include "engines/tiles/model/picture.h"
#include "engines/tiles/read/lenient_json.h"
#include "engines/tiles/read/vox.h"
#include "engines/tiles/request/read_style.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/write/png.h"
#include "engines/tiles/write/vox.h"
#include "tests/tiles/folder.h"

namespace solitaire::tiles {
namespace {

constexpr Rgba kBlue{13, 37, 114, 255}, kWhite{255, 255, 255, 255}, kRed{200, 0, 0, 255};

/// A folder with a sample of pixels: blue ways on white.
struct Samples : TestFolder {
  Samples() : TestFolder("solitaire-debroglie-") {
    Picture way(6, 6, kWhite);
    for (int at = 0; at < 6; ++at) way.at(at, 2) = kBlue;
    for (int at = 2; at < 6; ++at) way.at(4, at) = kBlue;
    write("way.png", write_png(way));
    for (const auto& [name, color] :
         {std::pair{"blue.png", kBlue}, {"white.png", kWhite}, {"red.png", kRed}}) {
      Picture icon(2, 2, color);
      icon.at(1, 0) = kRed;  // up and to the right
      write(name, write_png(icon));
    }
  }

  JobOptions options(const std::string& configuration) const {
    JobOptions options;
    options.inputs = {write("c.json", configuration)};
    options.debroglie = true;
    options.weights = WeightsKind::kStep;
    options.sampling.anneal = options.sampling.sweeps = 4;
    return options;
  }
  std::vector<std::string> maps(const std::string& configuration) const {
    Job job(options(configuration));
    std::vector<std::string> maps;
    CHECK(job.run([&](std::uint64_t) { maps.push_back(job.file("txt", 1, ".")); }) == JobEnding::kDone);
    return maps;
  }
  std::string error(const std::string& configuration) const {
    try {
      Job job(options(configuration));
      job.run([](std::uint64_t) {});
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      const std::string folder = path().string() + "/";
      return text.starts_with(folder) ? text.substr(folder.size()) : text;
    }
    return "";
  }
};

TEST_CASE("DeBroglie: a sample of pixels with a path, borders and fixed tiles") {
  const Samples samples;
  const std::string map = samples
                              .maps(R"({
    // what DeBroglie's own samples look like, with comments and commas too many
    "$schema": "./schema.json", "src": "way.png", "dest": "output/way.png", "backtrack": true, "animate": false,
    "model": {"type": "overlapping", "n": 3}, "periodicInput": false, "periodic": false, "symmetry": 8,
    "width": 12, "height": 9,
    "constraints": [
      {"type": "path", "pathTiles": ["#0D2572"]}, /* one network */
      {"type": "border", "tile": "#ffffff", "sides": "xmin, xmax"},
      {"type": "border", "tiles": ["#0d2572"], "sides": "ymin", "ban": true},
      {"type": "fixedTile", "tile": "#0d2572", "point": {"x": 5, "y": 4}},
      {"type": "count", "tiles": ["#0d2572"], "comparison": "atLeast", "count": 6},
    ],
  })")
                              .front();
  const std::size_t row = 13;
  const char white = map[0], blue = map[4 * row + 5];
  CHECK(white != blue);
  CHECK(std::ranges::count(map, blue) >= 6);
  for (std::size_t y = 0; y < 9; ++y) {
    CHECK(map[y * row] == white);
    CHECK(map[y * row + 11] == white);
  }
  for (std::size_t x = 0; x < 12; ++x) CHECK(map[x] == white);
}

TEST_CASE("DeBroglie: pictures of tiles with adjacencies, which turn with their tiles") {
  const Samples samples;
  const std::string tiles = R"("tiles": [
    {"src": "blue.png", "value": "corner", "tileSymmetry": "L", "multiplyFrequency": "200%"},
    {"src": "white.png", "value": "ground", "multiplyFrequency": 0.5}],)";
  const std::string adjacencies = R"("adjacencies": [
    {"left": ["ground"], "right": ["ground"], "comment": "flat"},
    {"left": ["corner!270"], "right": ["corner"]},
    {"left": ["corner", "corner!90"], "right": ["ground"]}])";
  Job job(samples.options("{" + tiles + adjacencies +
                          R"(, "symmetry": 8, "width": 6, "height": 5,
    "constraints": [{"type": "count", "tiles": ["corner"], "comparison": "atLeast", "count": 1}]})"));
  std::set<std::string> names;
  CHECK(job.run([&](std::uint64_t) {
    for (const ShownTile& tile : job.shown_tiles()) names.insert(tile.name);
  }) == JobEnding::kDone);
  // A corner needs all four: the one at its left or right, and those below or above them.
  CHECK(names == std::set<std::string>{"corner", "corner!90", "corner!180", "corner!270", "ground"});

  // Without symmetry nothing turns, and a corner has no neighbour above or below.
  CHECK(samples.error("{" + tiles + R"("adjacencies": [{"left": ["corner"], "right": ["corner!90"]}]})")
            .find("'adjacencies[0]': there is no tile 'corner!90'") != std::string::npos);
}

TEST_CASE("DeBroglie: what a configuration asks for is what the request says") {
  const Samples samples;
  const auto read = [&](const std::string& members) {
    return read_debroglie(samples.write("c.json", R"({"src": "way.png", )" + members + "}"));
  };
  const Request plain = read(R"("dest": "x.png")");
  CHECK(plain.size == Point{48, 48, 1});
  CHECK(plain.symmetry.members().size() == 1);

  const Request axes = read(R"("periodicX": true, "periodicInput": true, "symmetry": 4, "ground": "#ffffff",
    "baseDirectory": ".")");
  CHECK(axes.periodic == std::array<bool, 3>{true, false, false});
  CHECK(axes.exemplars.front().periodic == std::array<bool, 3>{true, true, false});
  CHECK(axes.symmetry.turns == 2);
  CHECK(axes.symmetry.mirrored);
  REQUIRE(axes.borders.size() == 2);
  CHECK(axes.borders[0].sides == std::vector<std::string>{"bottom"});
  CHECK((axes.borders[1].inside && axes.borders[1].forbidden));

  const Request rules = read(R"("constraints": [
    {"type": "edgedPath", "exits": {"1": ["x+", "yminus"]}, "endPoints": [{"x": 0, "y": 1}, {"x": 5, "y": 6, "z": 0}]},
    {"type": "maxConsecutive", "tiles": [3, "4"], "axes": ["y"]}, {"type": "maxConsecutive", "tile": 3, "maxCount": 7},
    {"type": "separation", "tiles": [1], "minDistance": 5}, {"type": "mirrorY"},
    {"type": "pairSeparation", "tiles1": [1], "tiles2": [2], "minDistance": 4},
    {"type": "acyclic", "pathSpec": {"type": "path", "tiles": [1]}},
    {"type": "loop", "pathSpec": {"type": "edged", "exits": {"2": ["x+", "x-"]}}},
    {"type": "count", "tiles": [1], "comparison": "exactly", "count": 2, "eager": false},
    {"type": "fixedTile", "tile": 9}])");
  REQUIRE(rules.paths.size() == 1);
  CHECK(rules.paths[0].over.open == std::vector<std::pair<std::string, std::string>>{{"1", "rt"}});
  CHECK(rules.paths[0].to == Point{5, 6, 0});
  REQUIRE(rules.runs.size() == 2);
  CHECK(rules.runs[0].axis == 1U);
  CHECK(rules.runs[0].most == 3);
  CHECK(rules.runs[1].most == 7);
  CHECK(rules.distances[0].least == 5);
  CHECK(rules.distances[1].others == std::vector<std::string>{"2"});
  CHECK(rules.acyclic.size() == 1);
  REQUIRE(rules.loops.size() == 1);
  CHECK(rules.loops[0].open.front().first == "2");
  CHECK((rules.counts[0].least == 2 && rules.counts[0].most == 2));
  CHECK((rules.counts[1].least == 1 && rules.counts[1].tiles == std::vector<std::string>{"9"}));
  CHECK(rules.notes.size() == 1);
  CHECK(rules.mirror->axis == 1);
  CHECK(rules.mirror->by_look);
}

TEST_CASE("DeBroglie: tiles whose pictures match at their sides are adjacent") {
  const Samples samples;
  // A pipe from left to right and an end of it, on white; the end is turned.
  Picture across(3, 3, kWhite), end(3, 3, kWhite), pale(3, 3, {253, 253, 253, 255});
  for (int x = 0; x < 3; ++x) across.at(x, 1) = kBlue;
  for (int x = 1; x < 3; ++x) end.at(x, 1) = kBlue;
  samples.write("across.png", write_png(across));
  samples.write("end.png", write_png(end));
  samples.write("pale.png", write_png(pale));
  const auto map = [&](const std::string& members) {
    return samples
        .maps(
            R"({"width": 9, "height": 1, "symmetry": 4, "reflectionalSymmetry": false, "rotationTreatment": "generated",
      "autoAdjacency": true, "tiles": [{"value": "-", "src": "across.png", "tileSymmetry": "I"},
      {"value": "e", "src": "end.png", "tileSymmetry": "T"}, {"value": "p", "src": "pale.png", "tileSymmetry": "X"}],
      "constraints": [{"type": "fixedTile", "tile": "e", "point": {"x": 2, "y": 0}},
        {"type": "count", "tiles": ["p"], "comparison": "atMost", "count": 9}])" +
            members + "}")
        .front();
  };
  CHECK(map("").size() > 9);
  const auto pairs = [&](const std::string& members) {
    const Request request = parse_debroglie(
        samples.path() / "c.json", R"({"autoAdjacency": true, "tiles": [{"value": "-", "src": "across.png"},
      {"value": "e", "src": "end.png"}, {"value": "p", "src": "pale.png"}])" +
                                       members + "}");
    const std::shared_ptr<Style> style = read_style(request);
    std::set<std::string> found;
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        const auto first = static_cast<Tile>(a), second = static_cast<Tile>(b);
        if (style->pairs[0].allowed(0, first, second))
          found.insert(style->tileset[first].name + style->tileset[second].name);
      }
    }
    return found;
  };
  CHECK(pairs("") == std::set<std::string>{"--", "e-", "pp"});
  CHECK(pairs(R"(, "autoAdjacencyTolerance": 0.01)") == std::set<std::string>{"--", "e-", "pp", "pe"});
  CHECK(pairs(R"(, "autoAdjacencyTolerance": 1)").size() == 9);
}

/// Tiles that are models of 2x2x2 voxels, as MagicaVoxel has them: y runs into the depth.
struct VoxelTiles : Samples {
  VoxelTiles() {
    VoxelModel model(Size{{2, 2, 2}});
    write("air.vox", write_vox(model));
    model.colors[model.size.site({1, 0, 0})] = model.colors[model.size.site({1, 1, 0})] = 7;
    write("side.vox", write_vox(model));  // a wall to the right
    model.palette.at(7) = kRed;
    write("red.vox", write_vox(model));
    write("bar.vox", write_vox(VoxelModel(Size{{2, 1, 2}})));
    write("flat.vox", write_vox(VoxelModel(Size{{2, 2, 1}})));
  }

  std::string configuration(const std::string& members) const {
    return R"({"srcType": "voxSet", "rotationalSymmetry": 4, "rotationTreatment": "generated", "autoAdjacency": true,
      "tiles": [{"src": "air.vox", "value": "air", "tileSymmetry": "X"},
                {"src": "side.vox", "value": "side", "tileSymmetry": "E"}], )" +
           members + "}";
  }
  /// Returns the map of such a configuration as a model.
  VoxelModel model(const std::string& members) const {
    Job job(options(configuration(members)));
    std::string bytes;
    CHECK(job.run([&](std::uint64_t) {
      bytes = job.file("vox", 1, ".");
      for (const ShownTile& tile : job.shown_tiles()) {
        CHECK(tile.name.starts_with("side"));  // air has nothing to show
        CHECK(tile.model->voxels.size() == 2);
      }
    }) == JobEnding::kDone);
    return read_voxel_model("map", bytes);
  }
  std::string error_of(const std::string& tiles) const {
    return error(R"({"srcType": "voxSet", "autoAdjacency": true, "tiles": [)" + tiles + "]}");
  }
};

TEST_CASE("DeBroglie: tiles that are models of voxels are adjacent where their sides are equal") {
  const VoxelTiles tiles;
  // Beside the wall is the other half of it, and above both is air, since nothing stands on air.
  const VoxelModel map = tiles.model(R"("width": 2, "height": 1, "depth": 2,
    "constraints": [{"type": "fixedTile", "tile": "side", "point": {"x": 0, "y": 0, "z": 0}}])");
  CHECK(map.size == Size{{4, 2, 4}});
  for_each_point(map.size, [&](const Point& at) {
    CHECK(map.at(at) == (at[2] == 0 && (at[0] == 1 || at[0] == 2) ? 7 : 0));
  });
}

TEST_CASE("DeBroglie: tiles that are models of voxels turn from the x axis to the y axis of the model") {
  const VoxelTiles tiles;
  const auto turned = [&](const std::string& tile) {
    return tiles.model(
        R"("width": 1, "height": 1, "depth": 1, "constraints": [{"type": "fixedTile", "tile": ")" + tile +
        R"(", "point": {"x": 0, "y": 0, "z": 0}}])");
  };
  const auto row = [](const VoxelModel& model, int y) { return model.at({0, y, 0}) + model.at({1, y, 0}); };
  CHECK(row(turned("side!90"), 0) == 14);  // the far one
  CHECK(row(turned("side!270"), 1) == 14);
}

TEST_CASE("DeBroglie: models of voxels that do not fit together are told") {
  const VoxelTiles tiles;
  const std::string air = R"({"src": "air.vox", "value": "air"}, )";
  CHECK(tiles.error_of(air + R"({"src": "blue.png", "value": "b"})") ==
        "c.json: 'tiles[1].src' is no .vox, as all tiles of a voxSet are");
  CHECK(tiles.error(R"({"tiles": [{"src": "air.vox", "value": "air"}]})") ==
        "c.json: 'tiles[0].src' is no .png; for .vox say \"srcType\": \"voxSet\"");
  CHECK(tiles.error_of(R"({"src": "bar.vox", "value": "b"})") ==
        "the model of 'b' stands on 2x1 voxels, which is no square");
  CHECK(tiles.error_of(air + R"({"src": "flat.vox", "value": "f"})") ==
        "the model of 'f' has 2x2 voxels, but that of 'air' 2x2x2; all are as large");
  CHECK(tiles.error_of(R"({"src": "side.vox", "value": "s"}, {"src": "red.vox", "value": "r"})") ==
        "the model of 'r' has another colour 7 than models before it; all have one palette");
  CHECK(tiles.error_of(R"({"src": "none.vox", "value": "n"})").find("none.vox") != std::string::npos);
}

TEST_CASE("DeBroglie: what has no meaning here is told with its place") {
  const Samples samples;
  const auto error = [&](const std::string& members) {
    return samples.error(R"({"src": "way.png", "width": 6, "height": 6, )" + members + "}");
  };
  CHECK(error(R"("widht": 4)") == "c.json: there is no member 'widht'; did you mean 'width'?");
  CHECK(error(R"("autoAdjacency": true)").find("'autoAdjacency' needs 'tiles' with a 'src'") !=
        std::string::npos);
  CHECK(error(R"("constraints": [{"type": "parity"}])")
            .find("'constraints[0].type' is 'parity', which is not read") != std::string::npos);
  CHECK(error(R"("constraints": [{"type": "border", "tile": "#ffffff", "sides": "north"}])")
            .find("has the side 'north'") != std::string::npos);
  CHECK(error(R"("constraints": [{"type": "fixedTile", "tile": "#ffffff", "point": {"x": 6, "y": 0}}])") ==
        "c.json: 'constraints[0].point.x' is no whole number from 0 to 5");
  CHECK(error(R"("constraints": [{"type": "border", "tile": "#123456"}])")
            .find("c.json: 'constraints[0]': there is no tile '#123456'; the tiles are '#ffffff'") == 0);
  CHECK(error(R"("rotationalSymmetry": 3)").find("three rotations") != std::string::npos);
  CHECK(error(R"("model": {"type": "deep"})") == "c.json: 'model.type' is neither adjacent nor overlapping");
  CHECK(error(R"("tiles": [{"value": "#ffffff", "multiplyFrequency": "many"}])").find("is no number") !=
        std::string::npos);
  CHECK(samples.error(R"({"src": "../way.png"})") ==
        "c.json: 'src' is no path within the folder of the configuration");
  CHECK(samples.error(R"({"src": "/etc/passwd"})").find("is no path within") != std::string::npos);
  CHECK(samples.error(R"({"src": "way.png", "baseDirectory": ".."})").find("is no path within") !=
        std::string::npos);
  CHECK(samples.error(R"({"srcType": "hexSet"})") ==
        "c.json: 'srcType' is none of sample, bitmapSet and voxSet");
  CHECK(samples.error("{\"src\": \"way.png\",\n  // here\n  \"width\": 4 4}") ==
        "c.json:3:14: this is no JSON");
  CHECK(samples.error("{}") == "there is no exemplar to learn from, and no tile has edges");
  const std::string whole =
      R"({"src": "way.png", "symmetry": 8, "constraints": [{"type": "border", "tile": "#ffffff"}]})";
  for (std::size_t length = 0; length < whole.size(); ++length)
    CHECK(samples.error(whole.substr(0, length)).starts_with("c.json:"));
}

TEST_CASE("comments and superfluous commas become blanks, and nothing else does") {
  CHECK(strict_json("[1, // one\n 2,]") == "[1,       \n 2 ]");
  CHECK(strict_json("{\"a\": \"//,]\", /* x\n */ }") == "{\"a\": \"//,]\"      \n    }");
  CHECK(strict_json("[\"\\\",\", 3 , ]") == "[\"\\\",\", 3   ]");
  CHECK(strict_json("[1,, 2]") == "[1,, 2]");
  CHECK(strict_json("\"open\\") == "\"open\\");
  CHECK(strict_json("/* open") == "       ");
}

}  // namespace
}  // namespace solitaire::tiles
