#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <unistd.h>
#include <zlib.h>

#include "base/file_error.h"
#include "engines/tiles/request/read_style.h"
#include "engines/tiles/tiled/tileset_files.h"
#include "engines/tiles/tiled/write_tiled.h"
#include "engines/tiles/write/png.h"

namespace solitaire::tiles {
namespace {

namespace fs = std::filesystem;

/// A folder that lives as long as this.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("solitaire-tiled-" + std::to_string(::getpid()))) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path write(const std::string& name, const std::string& bytes) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

const char* const kTileset =
    R"(<?xml version="1.0"?><tileset name="land" tilewidth="2" tileheight="2" tilecount="2" columns="2">
 <image source="land.png" width="4" height="2"/>
 <tile id="0"><properties><property name="name" value="grass"/></properties></tile></tileset>)";

std::string map_with(const std::string& layers, const std::string& tileset = R"(source="land.tsx")") {
  return R"(<?xml version="1.0"?><map orientation="orthogonal" width="3" height="2" tilewidth="2" tileheight="2"><tileset firstgid="5" )" +
         tileset + "/>" + layers + "</map>";
}

std::string layer(const std::string& data) {
  return R"(<layer id="1" name="ground" width="3" height="2">)" + data + "</layer>";
}

/// A folder with a tileset of two tiles, the second of which has a different colour in each corner.
struct Land : Folder {
  Land() {
    write("land.tsx", kTileset);
    Picture picture(4, 2, {10, 200, 10, 255});
    picture.at(2, 0) = {1, 0, 0, 255};
    picture.at(3, 0) = {2, 0, 0, 255};
    picture.at(2, 1) = {3, 0, 0, 255};
    picture.at(3, 1) = {4, 0, 0, 255};
    write("land.png", write_png(picture));
  }
};

std::string error_of(const fs::path& path) {
  try {
    Tileset tileset;
    read_tiled(path, tileset, true);
  } catch (const FileError& error) {
    const std::string text = error.what();
    return text.substr(path.parent_path().string().size() + 1);
  }
  return "";
}

/// The same for a tileset that is known.
std::string error_of_known(const fs::path& path, Tileset& tileset) {
  try {
    read_tiled(path, tileset, false);
  } catch (const FileError& error) {
    const std::string text = error.what();
    return text.substr(path.parent_path().string().size() + 1);
  }
  return "";
}

std::vector<std::string> names_in(const Grid& map, const Tileset& tileset) {
  std::vector<std::string> names;
  for (const Tile tile : map.tiles) names.push_back(tile == kHole ? "" : tileset[tile].name);
  return names;
}

std::string base64(const std::string& raw) {
  static constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t bit = 0; bit < 8 * raw.size(); bit += 6) {
    unsigned value = 0;
    for (std::size_t each = bit; each < bit + 6; ++each) {
      const bool set =
          each < 8 * raw.size() && (static_cast<unsigned char>(raw[each / 8]) >> (7 - each % 8) & 1U) != 0;
      value = 2 * value + (set ? 1 : 0);
    }
    text += kLetters[value];
  }
  while (text.size() % 4 != 0) text += '=';
  return text;
}

TEST_CASE("the encodings of a Tiled layer say the same") {
  const Land land;
  // 5, 6, 0, 6, 5, 5 as little-endian words.
  std::string bytes;
  for (const char gid : {5, 6, 0, 6, 5, 5}) bytes += {gid, 0, 0, 0};
  std::string packed(200, '\0');
  uLongf length = packed.size();
  REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &length,
                   reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) == Z_OK);
  packed.resize(length);
  const std::string kWays[] = {
      layer(R"(<data encoding="csv">5,6,0,
6,5,5</data>)"),
      layer(
          R"(<data><tile gid="5"/><tile gid="6"/><tile/><tile gid="6"/><tile gid="5"/><tile gid="5"/></data>)"),
      layer(R"(<data encoding="base64">)" + base64(bytes) + "</data>"),
      layer(R"(<data encoding="base64" compression="zlib">)" + base64(packed) + "</data>"),
      layer(R"(<data encoding="base64" compression="zstd">KLUv/QBoZQAAggEChSAAAee8fycA</data>)"),
      layer(
          R"(<data encoding="csv"><chunk x="-2" y="0" width="2" height="2">5,6,6,5</chunk><chunk x="0" y="0" width="1" height="2">0,5</chunk></data>)"),
  };
  for (const std::string& way : kWays) {
    CAPTURE(way);
    Tileset tileset;
    const Grid map = read_tiled(land.write("m.tmx", map_with(way)), tileset, true);
    CHECK(map.size == Size{{3, 2, 1}});
    CHECK(names_in(map, tileset) ==
          std::vector<std::string>{"grass", "land#1", "", "land#1", "grass", "grass"});
  }
  Tileset tileset;
  const fs::path json = land.write(
      "m.tmj",
      R"({"orientation": "orthogonal", "layers": [{"type": "tilelayer", "width": 3, "height": 2, "data": [5, 6, 0, 6, 5, 5]}], "tilesets": [{"firstgid": 5, "source": "land.tsx"}]})");
  const Grid map = read_tiled(json, tileset, true);
  CHECK(names_in(map, tileset) ==
        std::vector<std::string>{"grass", "land#1", "", "land#1", "grass", "grass"});
}

TEST_CASE("all eight orientations of a tile come back, and look as they should") {
  const Land land;
  std::string data;
  for (std::uint32_t flags = 0; flags < 8; ++flags)
    data += std::to_string(6 + (flags << 29U)) + (flags < 7 ? "," : "");
  const std::string eight = R"(<layer width="8" height="1"><data encoding="csv">)" + data + "</data></layer>";
  const fs::path path = land.write("m.tmx", map_with(eight));
  Tileset tileset;
  const Grid map = read_tiled(path, tileset, true);
  REQUIRE(tileset.size() == 8);
  // The reds of the corners: upper left, upper right, lower left, lower right. The flags are, from the lowest
  // bit on: diagonal, top to bottom, left to right.
  const std::array<std::array<int, 4>, 8> kCorners{{{1, 2, 3, 4},
                                                    {1, 3, 2, 4},
                                                    {3, 4, 1, 2},
                                                    {2, 4, 1, 3},
                                                    {2, 1, 4, 3},
                                                    {3, 1, 4, 2},
                                                    {4, 3, 2, 1},
                                                    {4, 2, 3, 1}}};
  for (Tile tile = 0; tile < 8; ++tile) {
    CAPTURE(static_cast<int>(tile));
    const Picture& icon = tileset[tile].icon;
    const std::array<int, 4> corners{icon.at(0, 0)[0], icon.at(1, 0)[0], icon.at(0, 1)[0], icon.at(1, 1)[0]};
    CHECK(corners == kCorners[tile]);
  }
  const std::string written = write_tmx(map, tileset, path, land.path() / "out");
  CHECK(written.find(R"(source="../land.tsx")") != std::string::npos);
  CHECK(written.find(data) != std::string::npos);
  Tileset again;
  CHECK(read_tiled(land.write("copy.tmx", write_tmx(map, tileset, path, land.path())), again, true) == map);
  // A map in another folder is known by its gids, and its tilesets are not looked for.
  CHECK(read_tiled(land.write("out/far.tmx", written), tileset, false) == map);
  const std::string other = map_with(R"(<layer width="1" height="1"><data encoding="csv">5</data></layer>)");
  CHECK(error_of_known(land.write("m.tmx", other), tileset) ==
        "m.tmx: has the gid 5, which is no tile of the tileset");
}

TEST_CASE("a written map keeps what Tiled knows of it, and has one layer") {
  const Land land;
  const fs::path path = land.write(
      "m.tmx", map_with(R"(<properties><property name="music" value="slow"/></properties>)" +
                        layer(R"(<data encoding="csv">5,6,0,6,5,5</data>)") + R"(<objectgroup id="7"/>)"));
  Tileset tileset;
  read_tiled(path, tileset, true);
  const std::string written = write_tmx(Grid(Size{{2, 1, 1}}, 0), tileset, path, land.path());
  CHECK(written.find("slow") != std::string::npos);
  CHECK(written.find("objectgroup") == std::string::npos);
  CHECK(written.find("\n5,5\n") != std::string::npos);
}

TEST_CASE("a tile of several visible layers is what stands there in all of them, and comes back so") {
  const Land land;
  const std::string
      ground = layer(R"(<data encoding="csv">5,5,0,6,5,5</data>)"),
      above = layer(R"(<data encoding="csv">0,2147483654,0,0,6,0</data>)"),
      roof = layer(R"(<data encoding="csv">0,0,5,0,0,0</data>)"),
      hidden = R"(<layer visible="0" width="3" height="2"><data encoding="csv">6,6,6,6,6,6</data></layer>)";
  const fs::path path = land.write("m.tmx", map_with(ground + hidden + above + roof));
  Tileset tileset;
  const Grid map = read_tiled(path, tileset, true);
  CHECK(names_in(map, tileset) ==
        std::vector<std::string>{"grass", "grass+land#1!h", "-+-+grass", "land#1", "grass+land#1", "grass"});
  const Picture& both = tileset[map[1]].icon;
  CHECK(both.at(0, 0)[0] == 2);  // the upper tile, mirrored
  const std::string written = write_tmx(map, tileset, path, land.path());
  CHECK(written.find("\n5,5,0,\n6,5,5\n") != std::string::npos);
  CHECK(written.find("\n0,2147483654,0,\n0,6,0\n") != std::string::npos);
  CHECK(written.find("\n0,0,5,\n0,0,0\n") != std::string::npos);
  CHECK(written.find("6,6,6") == std::string::npos);
  Tileset again;
  CHECK(read_tiled(land.write("copy.tmx", written), again, true) == map);
}

TEST_CASE("a tile's custom properties say its weight, its model and whether it turns") {
  const Land land;
  const std::string properties = R"(<properties><property name="name" value="tree"/>
    <property name="weight" type="float" value="2.5"/><property name="asset" value="oak"/>
    <property name="rotate" type="bool" value="false"/></properties>)";
  land.write("trees.tsx", R"(<tileset name="trees" tilewidth="2" tileheight="2"><tile id="0">)" + properties +
                              "</tile></tileset>");
  land.write("trees.tsj",
             R"({"name": "trees", "tilewidth": 2, "tileheight": 2, "tiles": [{"id": 0, "properties": [
    {"name": "name", "value": "tree"}, {"name": "weight", "value": 2.5}, {"name": "asset", "value": "oak"},
    {"name": "rotate", "value": false}]}]})");
  for (const std::string ending : {"tsx", "tsj"}) {
    CAPTURE(ending);
    Tileset tileset;
    read_tiled(land.write("m.tmx", map_with(layer(R"(<data encoding="csv">5,5,5,5,5,5</data>)"),
                                            "source=\"trees." + ending + "\"")),
               tileset, true);
    REQUIRE(tileset.size() == 1);
    CHECK(tileset[0].name == "tree");
    CHECK(tileset[0].bias == 2.5);
    CHECK(tileset[0].asset == "oak");
    CHECK_FALSE(tileset[0].rotates);
  }
  land.write("trees.tsx", R"(<tileset name="trees"><tile id="0"><properties>
    <property name="weight" value="-1"/></properties></tile></tileset>)");
  CHECK(error_of(land.write("m.tmx", map_with(layer(R"(<data encoding="csv">5,5,5,5,5,5</data>)"),
                                              R"(source="trees.tsx")")))
            .find("a tile has the weight -1") != std::string::npos);
}

TEST_CASE("a map of a tileset is written around it as .tmx and .tmj, and read back") {
  const Land land;
  const std::string wang =
      R"(<wangsets><wangset name="banks"><wangcolor name="water"/><wangcolor name="land"/>
    <wangtile tileid="0" wangid="1,0,1,0,1,0,1,0"/><wangtile tileid="2" wangid="2,0,1,0,2,0,1,0"/></wangset></wangsets>)";
  const fs::path path =
      land.write("a & b.tsx",
                 R"(<tileset name="banks" tilewidth="3" tileheight="2" columns="4">)" + wang + "</tileset>");
  Tileset tileset;
  read_tiles_of(path, tileset);
  REQUIRE(tileset.size() == 2);
  Grid map(Size{{2, 1, 1}});
  map.tiles = {1, 0};
  const std::string tmx = write_tmx(map, tileset, path, land.path());
  CHECK(tmx.find(R"(tilewidth="3" tileheight="2" width="2" height="1")") != std::string::npos);
  CHECK(read_tiled(land.write("m.tmx", tmx), tileset, false) == map);
  Tileset again;
  CHECK(read_tiled(land.write("m.tmj", write_tmj(map, tileset, path, land.path())), again, true).size ==
        map.size);
  CHECK(again[0].gid == 3U);
  CHECK(again[1].gid == 1U);
}

TEST_CASE("a map is written as .tmj after the pattern of one, and read back with its flags") {
  const Land land;
  const fs::path path =
      land.write("m.tmj", R"({"orientation": "orthogonal", "infinite": true, "music": "slow",
                   "tilesets": [{"firstgid": 5, "source": "land.tsx"}],
                   "layers": [{"type": "objectgroup", "name": "marks"},
                              {"type": "tilelayer", "name": "ground",
                               "chunks": [{"x": 0, "y": 0, "width": 2, "height": 1,
                                           "data": [5, 2147483654]}]}]})");
  Tileset tileset;
  const Grid map = read_tiled(path, tileset, true);
  REQUIRE(map.size == Size{{2, 1, 1}});
  const std::string moved = write_tmj(map, tileset, path, land.path() / "out");
  CHECK(moved.find(R"("source": "../land.tsx")") != std::string::npos);
  CHECK(moved.find("slow") != std::string::npos);
  CHECK(moved.find("marks") == std::string::npos);
  CHECK(moved.find("chunks") == std::string::npos);
  Tileset again;
  CHECK(read_tiled(land.write("copy.tmj", write_tmj(map, tileset, path, land.path())), again, true) == map);
  CHECK(again[1].gid == 2147483654U);
}

TEST_CASE("mistakes in maps of Tiled are told") {
  const Land land;
  const auto error = [&](const std::string& text) { return error_of(land.write("m.tmx", text)); };
  CHECK(error("<map").starts_with("m.tmx: byte "));
  CHECK(error("<tileset/>") == "m.tmx: is no map of Tiled");
  CHECK(error(map_with(layer(R"(<data encoding="csv">5,6</data>)"))) ==
        "m.tmx: a layer has 2 tiles, but its size says 6");
  CHECK(error(map_with(layer(R"(<data encoding="csv">5,6,5,5,5,5,5</data>)"))) ==
        "m.tmx: a layer has more tiles than its size says");
  CHECK(error(map_with(layer(R"(<data encoding="csv">1,5,5,5,5,5</data>)"))) ==
        "m.tmx: no tileset has the gid 1");
  CHECK(error(map_with(layer(R"(<data encoding="base64" compression="lzma">AAAA</data>)"))) ==
        "m.tmx: the compression 'lzma' is not read; save the map with zlib or csv");
  CHECK(error(map_with(layer(R"(<data encoding="base64" compression="zlib">AAAA</data>)"))) ==
        "m.tmx: a layer has packed data that are broken or of another size than it says");
  CHECK(error(map_with(R"(<layer width="1000000" height="1000000"><data encoding="csv">5</data></layer>)")) ==
        "m.tmx: a layer has more than 4194304 tiles");
  const std::string whole = layer(R"(<data encoding="csv">5,6,0,6,5,5</data>)");
  std::string many;
  for (int layer = 0; layer < 17; ++layer) many += whole;
  CHECK(error(map_with(many)) == "m.tmx: has more than 16 visible layers; hide the others");
  CHECK(error(map_with(whole, R"(source="../land.tsx")")).find("is not in the map's folder") !=
        std::string::npos);
  CHECK(error(map_with(whole, R"(source="/etc/passwd")")).find("is not in the map's folder") !=
        std::string::npos);
  CHECK(error(map_with("")) == "m.tmx: has no tiles");
}

TEST_CASE("entities of a map of Tiled are not resolved") {
  const Land land;
  const std::string text = R"(<!DOCTYPE m [<!ENTITY a "5,5,5,5,5,5"><!ENTITY b SYSTEM "/etc/passwd">]>)" +
                           map_with(layer(R"(<data encoding="csv">&a;&b;</data>)")).substr(21);
  CHECK(error_of(land.write("m.tmx", text)) == "m.tmx: a layer has data that are no numbers");
}

TEST_CASE("no beginning of a map of Tiled does harm") {
  const Land land;
  const std::string whole = map_with(layer(R"(<data encoding="csv">5,6,0,6,5,5</data>)"));
  for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
    CHECK(error_of(land.write("m.tmx", whole.substr(0, length))).starts_with("m.tmx: "));
  }
}

TEST_CASE("a map of Tiled that lies about its size takes no memory") {
  const Land land;
  const auto tmj = [&](const std::string& layer) {
    return error_of(land.write("m.tmj", R"({"layers": [{"type": "tilelayer", )" + layer + "}]}"));
  };
  CHECK(tmj(R"("width": 1000000, "height": 1000, "data": [1])") ==
        "m.tmj: a layer has a size or place that cannot be");
  CHECK(tmj(R"("width": 4000000000, "height": 1, "data": [1])") ==
        "m.tmj: 'layers[0].width' is no whole number from 1 to 1048576");
  CHECK(tmj(R"("encoding": "base64", "width": 1000000, "height": 1000, "data": "AAAA")") ==
        "m.tmj: a layer has more than 4194304 tiles");
  // Two chunks of a tile each, with an endless land between them.
  const std::string chunk = R"({"x": -1000000, "y": 0, "width": 1, "height": 1, "data": [1]})",
                    far = R"({"x": 1000000, "y": 1000, "width": 1, "height": 1, "data": [1]})";
  CHECK(tmj(R"("chunks": [)" + chunk + "," + far + "]") ==
        "m.tmj: a map of 2000001 x 1001 tiles is too large");
  CHECK(tmj(R"("width": 1, "height": 1, "data": [-1])") == "m.tmj: 'layers[0].data' has what is no gid");
  // A megabyte of zeros, packed into a kilobyte, in a layer of six tiles.
  std::string bomb(2000, '\0');
  uLongf size = bomb.size();
  const std::string zeros(1U << 20U, '\0');
  REQUIRE(compress(reinterpret_cast<Bytef*>(bomb.data()), &size, reinterpret_cast<const Bytef*>(zeros.data()),
                   zeros.size()) == Z_OK);
  bomb.resize(size);
  CHECK(error_of(land.write("m.tmx", map_with(layer(R"(<data encoding="base64" compression="zlib">)" +
                                                    base64(bomb) + "</data>")))) ==
        "m.tmx: a layer has packed data that are broken or of another size than it says");
  for (const std::string packed :
       {"KLUv/QRoTAAACAABAPz/ORACAgAQAAIAEAACABAAAgAQAAIAEAACABAAAwAQAPE+FuE=", "AAAA", ""}) {
    CAPTURE(packed);
    CHECK(error_of(land.write("m.tmx", map_with(layer(R"(<data encoding="base64" compression="zstd">)" +
                                                      packed + "</data>")))) ==
          "m.tmx: a layer has packed data that are broken or of another size than it says");
  }
}

/// Grass and water by the corners of tiles: 0 is grass, 1 water, 2 has water at its right.
const char* const kShore =
    R"(<?xml version="1.0"?><tileset name="shore" tilewidth="2" tileheight="2" tilecount="3" columns="3">
 <wangsets><wangset name="land" type="corner"><wangcolor name="grass"/><wangcolor name="water"/>
 <wangtile tileid="0" wangid="0,1,0,1,0,1,0,1"/><wangtile tileid="1" wangid="0,2,0,2,0,2,0,2"/>
 <wangtile tileid="2" wangid="0,2,0,2,0,1,0,1"/></wangset></wangsets></tileset>)";

TEST_CASE("a Wang set says what may be beside what") {
  const Land land;
  for (const bool as_json : {false, true}) {
    const fs::path file =
        as_json
            ? land.write(
                  "shore.tsj",
                  R"({"name": "shore", "tilewidth": 2, "tileheight": 2, "columns": 3, "wangsets": [{"colors":
 [{"name": "grass"}, {"name": "water"}], "wangtiles": [{"tileid": 0, "wangid": [0,1,0,1,0,1,0,1]},
 {"tileid": 1, "wangid": [0,2,0,2,0,2,0,2]}, {"tileid": 2, "wangid": [0,2,0,2,0,1,0,1]}]}]})")
            : land.write("shore.tsx", kShore);
    Request request;
    request.exemplars.push_back({file, "", false, {}});
    const auto style = read_style(request);
    REQUIRE(style->tileset.names() == std::vector<std::string>{"shore#0", "shore#1", "shore#2"});
    const PairRules& pairs = style->pairs.front();
    for (Tile a = 0; a < 3; ++a) {
      for (Tile b = 0; b < 3; ++b) {
        CAPTURE(int{a});
        CAPTURE(int{b});
        // To the right goes what has at its left what is at the right of the other.
        CHECK(pairs.allowed(0, a, b) == ((a == 0) == (b != 1)));
        CHECK(pairs.allowed(1, a, b) == (a == b));
      }
    }
  }
  Request without;
  without.exemplars.push_back({land.write("no.tsx", kTileset), "", false, {}});
  CHECK_THROWS_AS(read_style(without), FileError);
}

TEST_CASE("the labels of a Wang set turn with their tile, and count where they are asked for") {
  const Land land;
  land.write("shore.tsx", kShore);
  // The third tile as it is, and mirrored left to right: 7 and 7 with the highest bit.
  const fs::path map =
      land.write("bay.tmx", map_with(layer(R"(<data encoding="csv">7,6,2147483655,7,6,2147483655</data>)"),
                                     R"(source="shore.tsx")"));
  Request request;
  request.exemplars.push_back({map, "", false, {}});
  const auto allowed = [&](const char* a, const char* b) {
    const auto style = read_style(request);
    return style->pairs.front().allowed(0, style->tileset.find(a).value(), style->tileset.find(b).value());
  };
  CHECK(allowed("shore#1", "shore#2!h"));
  CHECK_FALSE(allowed("shore#2", "shore#2!h"));
  request.pairs = PairsFrom::kBoth;
  CHECK(allowed("shore#2", "shore#2!h"));
  CHECK(allowed("shore#2!h", "shore#2"));
  CHECK_FALSE(allowed("shore#1", "shore#2"));
  request.pairs = PairsFrom::kLabels;
  CHECK(allowed("shore#1", "shore#2!h"));
  request.pairs = PairsFrom::kSeen;
  CHECK_FALSE(allowed("shore#2!h", "shore#2"));
}

TEST_CASE("rectangles of the layer pins are pins, in sites") {
  const Land land;
  const std::string objects =
      R"(<objectgroup name="pins"><object id="1" name="grass" x="2" y="0" width="4" height="2"/>
 <object id="2" name="land#1|grass" x="0.1" y="1.9" width="1.9" height="2.1"/><object id="3" name="grass" x="5" y="3"><point/></object>
</objectgroup><objectgroup name="notes"><object id="4" name="?" x="-99" y="0"/></objectgroup>)";
  const std::string ground = layer(R"(<data encoding="csv">5,5,5,5,5,5</data>)");
  const std::vector<TiledPin> pins = read_pins(land.write("pins.tmx", map_with(ground + objects)));
  const fs::path as_json = land.write(
      "pins.tmj",
      R"({"width": 3, "height": 2, "tilewidth": 2, "tileheight": 2, "tilesets": [{"firstgid": 5, "source": "land.tsx"}],
 "layers": [{"type": "tilelayer", "width": 3, "height": 2, "data": [5,5,5,5,5,5]}, {"type": "objectgroup", "name": "pins",
 "objects": [{"name": "grass", "x": 2, "y": 0, "width": 4, "height": 2},
 {"name": "land#1|grass", "x": 0.1, "y": 1.9, "width": 1.9, "height": 2.1}, {"name": "grass", "x": 5, "y": 3}]}]})");
  for (const auto& found : {pins, read_pins(as_json)}) {
    REQUIRE(found.size() == 3);
    CHECK(found[0].from == Point{1, 0, 0});
    CHECK(found[0].to == Point{3, 1, 1});
    CHECK(found[1].from == Point{0, 1, 0});
    CHECK(found[1].to == Point{1, 2, 1});
    CHECK(found[1].tiles == std::vector<std::string>{"land#1", "grass"});
    CHECK(found[2].from == Point{2, 1, 0});
    CHECK(found[2].to == Point{3, 2, 1});
  }
  CHECK_THROWS_AS(read_pins(land.write("none.tmx", map_with(ground))), FileError);
  CHECK_THROWS_AS(read_pins(land.path() / "land.tsx"), FileError);
  for (const char* object :
       {R"(x="-5" y="0")", R"(x="1e300" y="0")", R"(x="nan" y="0")", R"(x="0" y="0" width="-1")"}) {
    CHECK_THROWS_AS(read_pins(land.write(
                        "bad.tmx", map_with(ground + R"(<objectgroup name="pins"><object name="grass" )" +
                                            object + "/></objectgroup>"))),
                    FileError);
  }
  CHECK_THROWS_AS(
      read_tileset(land.write(
          "wild.tsx",
          R"(<tileset><wangsets><wangset><wangtile wangid="0,9"/></wangset></wangsets></tileset>)")),
      FileError);
}

}  // namespace
}  // namespace solitaire::tiles
