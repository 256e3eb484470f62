#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/file_error.h"
#include "engines/tiles/read/json.h"
#include "engines/tiles/read/png.h"
#include "engines/tiles/request/request_file.h"
#include "engines/tiles/write/json.h"
#include "engines/tiles/write/png.h"
#include "engines/tiles/write/text.h"
#include "tests/tiles/fixture.h"

namespace solitaire::tiles {
namespace {

/// Returns what the error says that reading ends with; empty if it ends well.
template <class Read>
std::string error_of(Read read) {
  try {
    read();
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

std::string text_error(const std::string& text) {
  Tileset tileset;
  return error_of([&] { read_text("m.txt", text, tileset, true); });
}

TEST_CASE("text maps may have any characters, line ends and layers") {
  Tileset tileset;
  const Grid map = read_text("m.txt", "━ ┃\r\n┃━ \r\n\r\n  ┃\r\n┃┃┃\r\n\r\n", tileset, true);
  CHECK(map.size == Size{{3, 2, 2}});
  CHECK(tileset.names() == std::vector<std::string>{"━", " ", "┃"});
  CHECK(write_text(map, tileset) == "━ ┃\n┃━ \n\n  ┃\n┃┃┃\n");
}

TEST_CASE("mistakes in text maps are told with their place") {
  CHECK(text_error("") == "m.txt:1:1: there is no map; write a row of characters a line");
  CHECK(text_error("aaa\naa\n") ==
        "m.txt:2:3: this row has 2 characters, the first has 3; make all rows as long");
  CHECK(text_error("aa\naaa\n") ==
        "m.txt:2:3: this row has 3 characters, the first has 2; make all rows as long");
  CHECK(text_error("aa\n\xc3(\n") == "m.txt:2:1: this is no UTF-8; save the file in that encoding");
  CHECK(text_error("a\na\n\na\n").find("the layer that ends here has 1 rows, the first has 2") !=
        std::string::npos);
  std::string many;
  for (int code = 0; code < 300; ++code) {
    many += static_cast<char>(0xc0 + (0x100 + code) / 64);
    many += static_cast<char>(0x80 + (0x100 + code) % 64);
  }
  CHECK(text_error(many) == "m.txt:1:256: there are more than 255 different tiles");
}

TEST_CASE("a map becomes a picture and is read back") {
  Tileset tileset;
  const Grid map = read_text("m.txt", "abca\nccbb\n", tileset, true);
  const Picture picture = read_png("m.png", write_png(map, tileset, 5));
  CHECK(picture.width == 20);
  CHECK(picture.height == 10);
  Tileset cut;
  const Grid again = cut_tiles("m.png", picture, 5, cut, true);
  CHECK(cut.size() == 3);
  CHECK(again.tiles == map.tiles);
  CHECK(error_of([&] { cut_tiles("m.png", picture, 3, cut, true); }) ==
        "m.png: a picture of 20 x 10 pixels cannot be cut into squares of 3");
}

TEST_CASE("icons, holes and plain tiles become the same pixels in few colours and in many") {
  for (const int side : {2, 32}) {
    CAPTURE(side);
    Tileset tileset;
    Grid map = read_text("m.txt", "ab\n.a\n", tileset, true);
    Picture& icon = tileset[*tileset.find("a")].icon = Picture(side, side);
    for (int y = 0; y < side; ++y) {  // 1024 colours where it is large
      for (int x = 0; x < side; ++x)
        icon.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 7, 255};
    }
    std::ranges::replace(map.tiles, *tileset.find("."), kHole);
    const Picture picture = read_png("m.png", write_png(map, tileset, 1));
    REQUIRE(picture.width == 2 * side);
    CHECK(picture.at(side, 0) == tileset[*tileset.find("b")].color);
    CHECK(picture.at(side - 1, 2 * side - 1)[3] == 0);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        CHECK(picture.at(x, y) == icon.at(x, y));
        CHECK(picture.at(side + x, side + y) == icon.at(x, y));
      }
    }
  }
}

TEST_CASE("transparent squares of a picture are holes") {
  Picture picture(2, 1, {10, 20, 30, 255});
  picture.at(1, 0) = {10, 20, 30, 0};
  Tileset tileset;
  CHECK(cut_tiles("m.png", picture, 1, tileset, true).tiles == std::vector<Tile>{0, kHole});
}

TEST_CASE("no beginning of a PNG file, nor one with a changed byte, does harm") {
  Tileset tileset;
  const std::string whole = write_png(read_text("m.txt", "abca\nccbb\n", tileset, true), tileset, 4);
  for (std::size_t length = 0; length < whole.size() - 12;
       ++length) {  // the last chunk says only that it ends
    CHECK(error_of([&] { read_png("m.png", whole.substr(0, length)); }).starts_with("m.png: is "));
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x55);
    error_of([&] { read_png("m.png", changed); });
  }
}

TEST_CASE("a picture that claims to be huge takes no memory") {
  std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\x0f\x42\x40\0\x0f\x42\x40\x08\x06\0\0\0", 29);
  bytes += std::string("\0\0\0\0", 4);
  const std::string error = error_of([&] { read_png("m.png", bytes); });
  CHECK(error.starts_with("m.png: "));
}

TEST_CASE("a map becomes JSON and is read back") {
  Tileset tileset;
  Grid map = read_text("m.txt", "abca\nccbb\n", tileset, true);
  map[3] = kHole;
  const std::string text = write_json(map, tileset, {{"seed", 3}});
  CHECK(read_json("m.json", text, tileset, false) == map);
  Tileset other;
  CHECK(read_json("m.json", text, other, true) == map);
  CHECK(other.names() == tileset.names());
}

TEST_CASE("mistakes in JSON maps are told with their member") {
  const auto error = [](const std::string& text) {
    Tileset tileset;
    return error_of([&] { read_json("m.json", text, tileset, true); });
  };
  CHECK(error("{\"size\": [2, 1],\n}") == "m.json:2:1: this is no JSON");
  CHECK(error("[]") == "m.json: the file is no object");
  CHECK(error(R"({"size": [1000000, 1000000], "tiles": ["a"], "data": []})") ==
        "m.json: 'size' is too large");
  CHECK(error(R"({"size": [2, 1], "tiles": ["a"], "data": [0]})") ==
        "m.json: 'data' is no list of 2 numbers, as the size says");
  CHECK(error(R"({"size": [2, 1], "tiles": ["a"], "data": [0, 1]})") ==
        "m.json: 'data' has an entry [1] that is no number of a tile");
  CHECK(error(std::string(100'000, '[')) == "m.json: is nested too deeply");
  CHECK(error("2E11077") == "m.json: has a number that is too large");
}

/// A file that lives as long as this.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() / "solitaire_tiles_test.tiles.json") {
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST_CASE("mistakes in problem files are told with their member") {
  const auto error = [](const std::string& text) {
    const TemporaryFile file(text);
    const std::string whole = error_of([&] { read_request(file.path()); });
    const std::size_t end = whole.find(": ");
    return end == std::string::npos ? whole : whole.substr(end + 2);
  };
  CHECK(error(R"({"exemplars": ["a.txt"], "size": [3, 4]})").empty());
  CHECK(error(R"({"exemplar": ["a.txt"]})") == "there is no member 'exemplar'; did you mean 'exemplars'?");
  CHECK(error(R"({"exemplars": ["a.txt"], "borders": [{"side": "all", "tiles": ["b"], "colour": 3}]})") ==
        "there is no member 'borders[0].colour'; here may stand except, forbid, inside, side, tiles");
  CHECK(error(R"({"exemplars": ["../a.txt"]})") ==
        "'exemplars[0].file' is no path within the folder of the problem file");
  CHECK(error(R"({"exemplars": ["/etc/passwd"]})") ==
        "'exemplars[0].file' is no path within the folder of the problem file");
  CHECK(error(R"({"tiles": [{"name": "a", "color": "red"}]})") ==
        "'tiles[0].color' is no colour; write #rrggbb");
  CHECK(error(R"({"size": [0, 4]})") == "'size' is no list of 2 to 3 whole numbers from 1");
  CHECK(error(R"({"pins": [{"at": [1, 1]}]})") == "'pins[0].tiles' is missing");
}

}  // namespace
}  // namespace solitaire::tiles
