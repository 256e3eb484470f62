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

TEST_CASE(
    "examples: their scenes are valid glTF, without a warning, and assimp and three.js find in them what "
    "they hold") {
  const fs::path root = SOLITAIRE_SOURCE_DIR;
  const Workplace place;
  std::vector<std::string> validate = {"node", (root / "tests/gltf/validate.mjs").string()};
  for (const fs::path& example : files_with(root / "examples", ".sol")) {
    INFO("example: ", example.filename().string());
    const fs::path out = place / example.stem().string();
    const Outcome outcome = run_solitaire({"generate", example, "-n", "2", "-o", out});
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    for (const fs::path& scene : files_with(out, ".glb")) {
      validate.push_back(scene);
      const Outcome info = run({"assimp", "info", scene});
      CAPTURE(info.out);
      CHECK(info.status == 0);
    }
  }
  REQUIRE(validate.size() > 2);
  const Outcome report = run(validate);
  CAPTURE(report.out);
  CAPTURE(report.err);
  CHECK(report.status == 0);
  validate[1] = (root / "tests/gltf/read.mjs").string();
  const Outcome read = run(validate);
  CAPTURE(read.out);
  CAPTURE(read.err);
  CHECK(read.status == 0);
}

}  // namespace
}  // namespace solitaire
