// The examples as files: every scene that they make passes Khronos' validator and is read by assimp.
#include <algorithm>
#include <doctest/doctest.h>

#include "tests/support/command.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_with(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == extension) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// Checks that Khronos' validator has nothing to say of scenes, and that assimp and three.js find in them
/// what they hold.
void check_scenes(const std::vector<std::string>& scenes) {
  REQUIRE(!scenes.empty());
  for (const char* reader : {"validate.mjs", "read.mjs"}) {
    std::vector<std::string> command{"node", std::string(SOLITAIRE_SOURCE_DIR "/tests/gltf/") + reader};
    command.insert(command.end(), scenes.begin(), scenes.end());
    const Outcome report = run(command);
    CAPTURE(report.out);
    CAPTURE(report.err);
    CHECK(report.status == 0);
  }
}

TEST_CASE(
    "examples: their scenes are valid glTF, without a warning, and assimp and three.js find in them what "
    "they hold (slow)") {
  const fs::path root = SOLITAIRE_SOURCE_DIR;
  const Workplace place;
  std::vector<std::string> scenes;
  for (const fs::path& example : files_with(root / "examples", ".sol")) {
    INFO("example: ", example.filename().string());
    const fs::path out = place / example.stem().string();
    const Outcome outcome = run_solitaire({"generate", example, "-n", "2", "-o", out});
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    for (const fs::path& scene : files_with(out, ".glb")) {
      scenes.push_back(scene);
      const Outcome info = run({"assimp", "info", scene});
      CAPTURE(info.out);
      CHECK(info.status == 0);
    }
  }
  check_scenes(scenes);
}

TEST_CASE("examples: maps of tiles are valid glTF in each way that their tiles share nodes") {
  const fs::path houses = fs::path(SOLITAIRE_SOURCE_DIR) / "examples/tiles/houses.tiles.json";
  const Workplace place;
  std::vector<std::string> scenes;
  for (const char* nodes : {"each", "instances", "plain", "chunks"}) {
    const fs::path out = place / nodes;
    const Outcome outcome = run_solitaire(
        {"tiles", houses, "--anneal", "6", "--sweeps", "4", "--format", "glb", "--nodes", nodes, "-o", out});
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    scenes.push_back(out / "houses-0001.glb");
  }
  check_scenes(scenes);
}

}  // namespace
}  // namespace solitaire
