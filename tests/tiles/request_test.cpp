// What a problem file and the options say, as maps show it.
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <set>
#include <unistd.h>

#include "base/file_error.h"
#include "engines/tiles/job/job.h"
#include "engines/tiles/model/picture.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/write/png.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

namespace fs = std::filesystem;

/// A folder with the files of a request, which lives as long as this.
class RequestFolder {
 public:
  RequestFolder() : path_(fs::temp_directory_path() / ("solitaire-request-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~RequestFolder() { fs::remove_all(path_); }
  RequestFolder(const RequestFolder&) = delete;
  RequestFolder& operator=(const RequestFolder&) = delete;

  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return (path_ / name).string();
  }
  JobOptions options(const std::string& problem) const {
    JobOptions made;
    made.inputs = {write("p.tiles.json", problem)};
    made.sampling.anneal = made.sampling.sweeps = 3;
    return made;
  }

 private:
  fs::path path_;
};

/// Returns the rows of the maps that a job makes, as text.
std::vector<std::string> maps_of(Job& job) {
  std::vector<std::string> maps;
  const JobEnding ending = job.run([&](std::uint64_t) { maps.push_back(job.file("txt", 8, ".")); });
  CHECK(ending == JobEnding::kDone);
  return maps;
}
std::vector<std::string> maps_of(const JobOptions& options) {
  Job job(options);
  return maps_of(job);
}

std::string error_of(const JobOptions& options) {
  try {
    maps_of(options);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("weights that were learned and read again make the same maps") {
  const RequestFolder folder;
  folder.write("streets.txt", kStreets);
  const std::string head =
      R"({"exemplars": ["streets.txt"], "size": [12, 9], "shapes": [[1, 1], [2, 1], [2, 2]])";
  const JobOptions learned = folder.options(head + R"(, "weights": "step", "epsilon": 0.7})");
  Job job(learned);
  const std::string weights = job.weights();
  const std::vector<std::string> maps = maps_of(job);
  folder.write("w.json", weights);
  JobOptions read = folder.options(head + R"(, "weights": "w.json"})");
  CHECK(maps_of(read) == maps);
  CHECK(Job(read).weights() == weights);

  const auto complaint = [&](const std::string& text) {
    return error_of((folder.write("w.json", text), folder.options(head + R"(, "weights": "w.json"})")));
  };
  CHECK(complaint(weights.substr(0, weights.size() / 2)).find("w.json:") != std::string::npos);
  CHECK(complaint(
            R"({"shapes": [{"size": [1, 1], "others": [0], "patches": [{"tiles": ["?"], "weights": [1]}]}]})")
            .find("shapes[0].patches[0].tiles' name '?', which is no tile") != std::string::npos);
  CHECK(complaint(R"({"shapes": [{"size": [9, 9], "others": [0], "patches": []}]})").find("has more than") !=
        std::string::npos);
  CHECK(
      complaint(R"({"shapes": [{"size": [1, 1], "others": [1e9], "patches": []}]})").find("from -20 to 20") !=
      std::string::npos);
  CHECK(complaint(R"({"shapes": [{"size": [1, 1], "others": [0, 0], "patches": []}]})")
            .find("one for each zone") != std::string::npos);
}

TEST_CASE("a mask says what of a map is made anew") {
  const RequestFolder folder;
  folder.write("streets.txt", kStreets);
  JobOptions options =
      folder.options(R"({"exemplars": ["streets.txt"], "size": [16, 10], "weights": "step"})");
  const std::string first = maps_of(options).front();
  options.from = folder.write("first.txt", first);
  Picture mask(4, 2, {0, 0, 0, 255});
  mask.at(3, 0) = {255, 255, 255, 255};  // columns 12 to 15 of rows 0 to 4
  mask.at(0, 1) = {255, 255, 255, 0};    // transparent: stays
  options.redo = folder.write("mask.png", write_png(mask));
  options.maps = 12;
  std::set<std::string> made;
  for (const std::string& map : maps_of(options)) {
    made.insert(map);
    for (std::size_t at = 0; at < map.size(); ++at) {
      const std::size_t x = at % 17, y = at / 17;
      if (x < 12 || y > 4) REQUIRE(map[at] == first[at]);
    }
  }
  CHECK(made.size() > 3);
}

TEST_CASE("pins count from either side and repeat as often as they fit, in maps of any size") {
  const RequestFolder folder;
  folder.write("any.txt", "..#.\n.##.\n#..#\n");
  const std::string head = R"({"exemplars": ["any.txt"], "weights": "step", "size": [7, 6], "pins": [)";
  const auto map_with = [&](const std::string& pin) {
    return maps_of(folder.options(head + pin + "]}")).front();
  };
  const std::string corner = map_with(R"({"at": [-2, -1], "size": [2, 1], "tiles": ["#"]},
    {"at": [-7, -6], "tiles": ["."]}, {"at": [0, -1], "tiles": ["."]})");
  CHECK(corner.ends_with("##\n"));
  CHECK(corner.starts_with("."));
  CHECK(corner[5 * 8] == '.');

  JobOptions options = folder.options(head + R"({"at": [1, 2], "every": [3, 0], "tiles": ["#"]},
    {"at": [0, 2], "every": [3, 3], "tiles": ["."]}]})");
  for (const int width : {4, 7, 8}) {
    options.width = width;
    const std::string map = maps_of(options).front();
    for (int x = 0; x < width; ++x) {
      const auto at = [&](int y) { return map[static_cast<std::size_t>(y * (width + 1) + x)]; };
      if (x % 3 == 1) CHECK(at(2) == '#');
      if (x % 3 == 0) CHECK(std::string{at(2), at(5)} == "..");
    }
  }
  options.width = 7;
  options.pins = {"-1,0=#", "-3,-2:-2,-1=."};
  const std::string by_option = maps_of(options).front();
  CHECK(by_option[6] == '#');
  CHECK(by_option.substr(4 * 8 + 4, 2) + by_option.substr(5 * 8 + 4, 2) == "....");

  const std::string lower = map_with(R"({"at": [0, 0], "to": [-1, -3], "tiles": ["."]})");
  CHECK(lower.starts_with(".......\n.......\n.......\n.......\n"));
  CHECK(lower.find('#') != std::string::npos);

  const auto refused = [&](const std::string& pin) { return error_of(folder.options(head + pin + "]}")); };
  for (const char* outside : {"[7, 0]", "[0, -7]", "[-8, 0]"}) {
    CHECK(refused(std::string(R"({"at": )") + outside + R"(, "tiles": ["."]})")
              .find("repeats a pin as often") != std::string::npos);
  }
  CHECK(refused(R"({"at": [0, 0], "size": [3, 1], "every": [2, 0], "tiles": ["."]})")
            .find("'every' is smaller") != std::string::npos);
}

TEST_CASE("counts can be shares of a map of any size") {
  const RequestFolder folder;
  folder.write("any.txt", "..#.\n.##.\n#..#\n");
  JobOptions options = folder.options(R"({"exemplars": ["any.txt"], "weights": "step",
    "counts": [{"tiles": ["#"], "least_share": 0.7, "most_share": 0.72}]})");
  for (const int side : {5, 10, 14}) {
    options.width = options.height = side;
    const std::string map = maps_of(options).front();
    const auto share = static_cast<double>(std::ranges::count(map, '#')) / (side * side);
    CHECK(share >= 0.7);
    CHECK(share <= 0.72);
  }
  options.width = options.height = 3;
  CHECK(error_of(options).find("at least 7 of '#' are asked for, and there can be at most 6") !=
        std::string::npos);
}

TEST_CASE("zones that are drawn anew say what each square of sites is made of") {
  const RequestFolder folder;
  folder.write("checks.txt", "ab\nba\n");
  folder.write("stripes.txt", "cd\ncd\ndc\n");
  folder.write("both.txt", "abababcdcd\nbabababcdc\n");
  folder.write("coarse.txt", "12\n21\n11\n22\n");
  folder.write("coarse.tiles.json",
               R"({"exemplars": ["coarse.txt"], "tiles": [{"name": "checks", "char": "1"},
    {"name": "stripes", "char": "2"}], "weights": "step"})");
  const std::string problem = R"({"exemplars": [{"file": "checks.txt", "zone": "checks"},
    {"file": "stripes.txt", "zone": "stripes"}, {"file": "both.txt", "zone": "checks"}], "size": [10, 9], "weights": "step",
    "zones": {"from": "coarse.tiles.json", "scale": 4}})";
  JobOptions options = folder.options(problem);
  options.maps = 6;
  const std::vector<std::string> maps = maps_of(options);
  CHECK(std::set<std::string>(maps.begin(), maps.end()).size() > 1);
  CHECK(maps_of(options) == maps);
  options.jobs = 3;
  CHECK(maps_of(options) == maps);
  CHECK_THROWS_AS(Job(options).count(), RequestError);

  folder.write("coarse.tiles.json", R"({"exemplars": ["coarse.txt"], "weights": "step"})");
  CHECK(error_of(folder.options(problem)).find("no exemplar has the zone '1'") != std::string::npos);
  folder.write("coarse.tiles.json",
               R"({"exemplars": ["coarse.txt"], "zones": {"from": "coarse.tiles.json"}})");
  CHECK(error_of(folder.options(problem)).find("more than 4 deep") != std::string::npos);
}

TEST_CASE("chunks that are made alone are those that are made together") {
  const RequestFolder folder;
  folder.write("streets.txt", kStreets);
  JobOptions options = folder.options(R"({"exemplars": ["streets.txt"], "size": [9, 7], "weights": "step"})");
  options.chunks = {"-1,0", "0,0", "5,-3"};
  options.jobs = 2;
  const std::vector<std::string> maps = maps_of(options);
  REQUIRE(maps.size() == 3);
  options.chunks = {"5,-3"};
  CHECK(maps_of(options).front() == maps[2]);
  options.chunks = {"0,0"};
  CHECK(maps_of(options).front() == maps[1]);
  options.chunks = {"0;0"};
  CHECK(error_of(options).find("is no chunk") != std::string::npos);
  options.chunks = {"0,9000000000000000000"};
  CHECK(error_of(options).find("too far") != std::string::npos);
  options.chunks = {"0,0"};
  options.pins = {"0,0=."};
  CHECK(error_of(options).find("have no pins") != std::string::npos);
}

TEST_CASE("a map is not asked for more of a tile than it has sites, nor for more than at most") {
  const RequestFolder folder;
  folder.write("streets.txt", kStreets);
  const auto error = [&](const std::string& count) {
    return error_of(folder.options(
        R"({"exemplars": ["streets.txt"], "size": [6, 5], "weights": "step", "counts": [)" + count + "]}"));
  };
  CHECK(error(R"({"tiles": ["."], "least": 31})")
            .ends_with(
                "p.tiles.json: 'counts[0]': at least 31 of '.' are asked for, and there can be at most 30"));
  CHECK(error(R"({"tiles": ["."], "least": 4, "most": 3})")
            .ends_with(
                "p.tiles.json: 'counts[0]': at least 4 of '.' are asked for, and there can be at most 3"));
}

TEST_CASE("keys are read, and their doors are passable of themselves") {
  const RequestFolder folder;
  folder.write("rooms.txt", ".#Aa\n#Aa.\nAa.#\na.#A\n..aA\n.aA.\n");
  JobOptions options = folder.options(R"({"exemplars": ["rooms.txt"], "size": [8, 1], "weights": "step",
    "pins": [{"at": [0, 0], "tiles": ["."]}], "counts": [{"tiles": ["A"], "least": 1}],
    "keys": [{"from": [0, 0], "tiles": ["."], "doors": {"A": "a"}}]})");
  options.maps = 20;
  for (const std::string& map : maps_of(options)) {
    CAPTURE(map);
    CHECK(map.find('a') < map.find('A'));
    CHECK(map.find('#') > map.find_last_of(".aA"));
  }
  CHECK(error_of(folder.options(R"({"exemplars": ["rooms.txt"], "keys": [{"from": [99, 0], "tiles": ["."],
    "doors": {"A": "a"}}]})"))
            .find("the place where one begins at (99,0) is outside") != std::string::npos);
}

}  // namespace
}  // namespace solitaire::tiles
