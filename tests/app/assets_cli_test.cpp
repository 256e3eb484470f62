// The models as the command line lists and draws them.
#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/support/command.h"
#include "tests/support/text.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kSizes = R"(
for name in ["chair", "fridge", "plate_2x1"]: print(name, size_of(name), has_front(name));
)";

}  // namespace

TEST_CASE("assets: each bundled file is listed once, in its set") {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SOLITAIRE_SOURCE_DIR) / "assets"))
    files += entry.path().extension() == ".glb" ? 1 : 0;
  const Outcome table = run_solitaire({"assets"});
  CHECK(table.status == 0);
  CHECK(lines_of(table.out).size() == files + 1);  // and a heading
  const Outcome objects = run_solitaire({"assets", "--json"});
  CHECK(lines_of(objects.out).size() == files);
  for (const std::string& line : lines_of(objects.out)) CHECK_FALSE(json::parse(line)["set"].empty());
}

TEST_CASE("assets: a listed size and front are what a program reads") {
  const Workplace place;
  place.file("sizes.sol", kSizes);
  const std::vector<std::string> printed = lines_of(run_solitaire({"solve", place / "sizes.sol"}).err);
  for (const char* name : {"chair", "fridge", "plate_2x1"}) {
    const json listed = json::parse(run_solitaire({"assets", name, "--json"}).out);
    const auto is_about = [&](const std::string& line) { return line.starts_with(std::string(name) + " "); };
    const auto line = std::find_if(printed.begin(), printed.end(), is_about);
    REQUIRE(line != printed.end());
    const json size = json::parse(line->substr(line->find('['), line->find(']') - line->find('[') + 1));
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(size[i].get<double>() == doctest::Approx(listed["size"][i].get<double>()).epsilon(1e-3));
    CHECK(line->ends_with(listed["front"].get<bool>() ? "true" : "false"));
  }
}

TEST_CASE("assets: models and sets are drawn where they are asked for, with a sheet for each set") {
  const Workplace place;
  const Outcome outcome =
      run_solitaire({"assets", "shapes", "chair", "--png-size", "32x24", "-o", place / "models"});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  for (const char* name : {"cone.png", "chair.png", "models-shapes.png", "models-living.png"})
    CHECK(bytes_of(place / "models" / name).substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK_FALSE(fs::exists(place / "models/table.png"));
  CHECK(outcome.err.find("models-shapes.png") != std::string::npos);
}

TEST_CASE("assets: a folder of one's own comes first, and a name that there is not is an error") {
  const Workplace place;
  fs::create_directories(place / "mine");
  fs::copy_file(fs::path(SOLITAIRE_SOURCE_DIR) / "assets/fridge.glb", place / "mine/chair.glb");
  const json mine = json::parse(run_solitaire({"assets", "chair", "--assets", place / "mine", "--json"}).out);
  const json fridge = json::parse(run_solitaire({"assets", "fridge", "--json"}).out);
  CHECK(mine["size"] == fridge["size"]);
  const Outcome outcome = run_solitaire({"assets", "unicorn"});
  CHECK(outcome.status != 0);
  CHECK(outcome.err.find("there is no model and no set of models 'unicorn'") != std::string::npos);
}

}  // namespace solitaire
