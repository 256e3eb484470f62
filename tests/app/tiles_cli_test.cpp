// Maps of tiles as the command line makes them.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <string>
#include <string_view>

#include "tests/support/command.h"

namespace solitaire {
namespace {

/// A problem of two tiles that stand in any order, in which trees are shown as the model `asset`.
std::string wood(std::string_view asset) {
  return fmt::format(R"({{"exemplars": ["wood.txt"], "size": [6, 5],
    "tiles": [{{"name": "tree", "char": "T", "asset": "{}"}}, {{"name": "grass", "char": ".", "height": 0.1}}]}})",
                     asset);
}

}  // namespace

TEST_CASE("tiles: maps whose tiles are models are written with their scenes, and the page shows them") {
  const Workplace place;
  place.file("wood.txt", "T.TT.\n..T.T\nTT..T\n");
  const std::string problem = place.file("wood.tiles.json", wood("tree"));
  const Outcome outcome = run_solitaire(
      {"tiles", problem, "--weights", "step", "-n", "2", "--format", "txt,glb", "-o", place / "out"});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.find("no model") == std::string::npos);
  for (const char* name : {"wood-0001", "wood-0002"}) {
    CHECK(bytes_of(place / fmt::format("out/{}.glb", name)).starts_with("glTF"));
    CHECK(bytes_of(place / fmt::format("out/page/{}.js", name)).size() > 10'000);  // with the tree's mesh
  }
  CHECK(bytes_of(place / "out/wood-0001.glb").find("\"tree\"") != std::string::npos);
}

TEST_CASE("tiles: a .glb has a node for each tile, or one for all that look alike, with names or without") {
  const Workplace place;
  place.file("wood.txt", "T.TT.\n..T.T\nTT..T\n");
  const std::string problem = place.file("wood.tiles.json", wood("tree"));
  const auto bytes = [&](const std::string& nodes) {
    const Outcome outcome =
        run_solitaire({"tiles", problem, "--weights", "step", "-W", "30", "-H", "20", "--nodes", nodes,
                       "--format", "glb", "-o", (place / nodes).string()});
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    return bytes_of(place / (nodes + "/wood-0001.glb"));
  };
  const std::string each = bytes("each"), instances = bytes("instances"), plain = bytes("plain");
  CHECK(each.find("EXT_mesh_gpu_instancing") == std::string::npos);
  CHECK(instances.find("EXT_mesh_gpu_instancing") != std::string::npos);
  CHECK(instances.find("site[0][3][4]") != std::string::npos);
  CHECK(plain.find("EXT_mesh_gpu_instancing") != std::string::npos);
  CHECK(plain.find("site[0][3][4]") == std::string::npos);
  const std::string chunks = bytes("chunks");
  CHECK(chunks.find("EXT_mesh_gpu_instancing") == std::string::npos);
  CHECK(chunks.find("grass chunk") != std::string::npos);
  CHECK(each.size() > instances.size());
  CHECK(instances.size() > plain.size() + 20'000);
}

TEST_CASE("tiles: maps whose tiles are models of voxels show them, and are one model") {
  const Workplace place;
  // MagicaVoxel's form of a model of 2x2x2 with a voxel in a corner, whose colour is the palette's.
  const std::string size = {2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0}, voxels = {1, 0, 0, 0, 1, 0, 0, 5};
  const auto chunk = [](const std::string& id, const std::string& content, char inside = 0) {
    return id + std::string{static_cast<char>(content.size()), 0, 0, 0, inside, 0, 0, 0} + content;
  };
  const std::string chunks = chunk("SIZE", size) + chunk("XYZI", voxels);
  place.file("post.vox", std::string{'V', 'O', 'X', ' ', -106, 0, 0, 0} +
                             chunk("MAIN", "", static_cast<char>(chunks.size())) + chunks);
  place.file("wood.txt", "T.TT.\n..T.T\nTT..T\n");
  const std::string problem = place.file("wood.tiles.json", R"({"exemplars": ["wood.txt"], "size": [6, 5],
    "tiles": [{"name": "tree", "char": "T", "voxels": "post.vox"},
              {"name": "grass", "char": ".", "voxels": "post.vox", "height": 0}]})");
  const Outcome outcome =
      run_solitaire({"tiles", problem, "--weights", "step", "--format", "vox,glb", "-o", place / "out"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.err.find("no model") == std::string::npos);
  const std::string model = bytes_of(place / "out/wood-0001.vox");
  const std::size_t extent = model.find("SIZE") + 12;
  CHECK(model.substr(extent, 12) == std::string{12, 0, 0, 0, 10, 0, 0, 0, 2, 0, 0, 0});
  CHECK(bytes_of(place / "out/wood-0001.glb").find("tree.vox") != std::string::npos);
}

TEST_CASE("tiles: what an option cannot have is answered with what it can") {
  const auto error = [](const std::string& option, const std::string& word) {
    const Outcome outcome = run_solitaire({"tiles", "wood.txt", option, word});
    CHECK(outcome.status == 2);
    return outcome.err.substr(0, outcome.err.find('\n'));
  };
  CHECK(error("--sampler", "plugs") ==
        "--sampler: plugs not in {windows,blockss,wfc,raster,mh,gibbs,search}");
  CHECK(error("--weights", "0") == "--weights: 0 not in {fitted,step}");
  CHECK(error("--nodes", "all") == "--nodes: all not in {each,instances,plain,chunks}");
  CHECK(error("--seed", "-1") == "--seed: '-1' is not a whole number from 0, of at most 19 digits");
  CHECK(error("--sweeps", "-1").ends_with("not in range 0 to 1000000000"));
  CHECK(error("--timeout", "-1") == "--timeout: '-1' is not a number of seconds from 0");
  CHECK(error("--memory", "nan") == "--memory: 'nan' is not a number of megabytes above 0");
}

TEST_CASE("tiles: a model that there is not is told at the end") {
  const Workplace place;
  place.file("wood.txt", "T.TT.\n..T.T\nTT..T\n");
  const std::string problem = place.file("wood.tiles.json", wood("treee"));
  const Outcome outcome =
      run_solitaire({"tiles", problem, "--weights", "step", "--format", "glb", "-o", place / "out"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.find("treee (did you mean tree?): no model is called so") != std::string::npos);
}

}  // namespace solitaire
