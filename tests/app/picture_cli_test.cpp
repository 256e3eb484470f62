// Pictures as the command line writes them.
#include <doctest/doctest.h>

#include "tests/support/command.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPicturedScene = R"(
x = range(1, 9);
place("chair", at: [x, 0]);
place("table", at: [0, range(2, 5)]);
return x;
)";

Outcome generate(const Workplace& place, const std::string& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"generate", place / "scene.sol", "-o", place / folder};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_solitaire(arguments);
}

}  // namespace

TEST_CASE("cli: --png writes the same pictures for any number of jobs, and after an interruption") {
  const Workplace place;
  place.file("scene.sol", kPicturedScene);
  REQUIRE(generate(place, "one", {"-n", "3", "--png-size", "64x48", "--jobs", "1"}).status == 0);
  for (const char* name : {"scene-0001.png", "scene-0002.png", "scene-0003.png", "sheet.png"}) {
    CAPTURE(name);
    CHECK(bytes_of(place / "one" / name).substr(0, 8) == "\x89PNG\r\n\x1a\n");
  }
  CHECK(bytes_of(place / "one/scene-0001.png") != bytes_of(place / "one/scene-0002.png"));
  CHECK(bytes_of(place / "one/index.html").find("<img src=\"./scene-0002.png\"") != std::string::npos);

  CHECK(generate(place, "two", {"-n", "3", "--png", "--png-size", "64x48", "--jobs", "2"}).status == 0);
  CHECK(generate(place, "parts", {"-n", "2", "--png-size", "64x48"}).status == 0);
  CHECK(generate(place, "parts", {"-n", "3", "--png-size", "64x48", "--resume"}).status == 0);
  CHECK(run({"diff", "-r", place / "one", place / "two"}).out == "");
  CHECK(run({"diff", "-r", place / "one", place / "parts"}).out == "");
}

TEST_CASE("cli: --camera eye draws pictures of its own beside those from above") {
  const Workplace place;
  place.file("scene.sol", kPicturedScene);
  REQUIRE(generate(place, "out", {"-n", "2", "--png-size", "64x48"}).status == 0);
  const std::string above = bytes_of(place / "out/scene-0001.png");
  REQUIRE(generate(place, "out", {"-n", "2", "--png-size", "64x48", "--camera", "eye", "--resume"}).status ==
          0);
  CHECK(bytes_of(place / "out/scene-0001.png") == above);
  CHECK(bytes_of(place / "out/scene-0001-eye.png").substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(bytes_of(place / "out/scene-0001-eye.png") != above);
  CHECK(fs::exists(place / "out/sheet-eye.png"));
  CHECK(bytes_of(place / "out/index.html").find("<img src=\"./scene-0002-eye.png\"") != std::string::npos);

  REQUIRE(
      generate(place, "again", {"-n", "2", "--camera", "eye", "--png-size", "64x48", "--jobs", "2"}).status ==
      0);
  CHECK(bytes_of(place / "again/scene-0001-eye.png") == bytes_of(place / "out/scene-0001-eye.png"));
  CHECK_FALSE(fs::exists(place / "again/scene-0001.png"));
  const Outcome wrong = generate(place, "out", {"--camera", "behind"});
  CHECK(wrong.status == 2);
  CHECK(wrong.err.find("--camera") != std::string::npos);
}

TEST_CASE("cli: without --png there are no pictures, nor of solutions that place nothing") {
  const Workplace place;
  place.file("scene.sol", kPicturedScene);
  CHECK(generate(place, "out", {"-n", "1"}).status == 0);
  CHECK_FALSE(fs::exists(place / "out/scene-0001.png"));
  CHECK_FALSE(fs::exists(place / "out/sheet.png"));
  place.file("scene.sol", "return range(1, 3);\n");
  CHECK(generate(place, "values", {"-n", "1", "--png"}).status == 0);
  CHECK(fs::exists(place / "values/scene-0001.json"));
  CHECK_FALSE(fs::exists(place / "values/scene-0001.png"));
  CHECK_FALSE(fs::exists(place / "values/sheet.png"));
}

TEST_CASE("cli: what is no size of a picture is refused") {
  const Workplace place;
  place.file("scene.sol", kPicturedScene);
  for (const char* size :
       {"", "64", "x48", "64x", "64x48x", "0x48", "64x0", "-64x48", "64 x 48", "70000x70000"}) {
    CAPTURE(size);
    const Outcome outcome = generate(place, "out", {"--png-size", size});
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("is no size of a picture") != std::string::npos);
  }
  CHECK_FALSE(fs::exists(place / "out"));
}

}  // namespace solitaire
