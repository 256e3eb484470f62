#include "engines/tiles/read/vox.h"

#include <doctest/doctest.h>

#include "base/file_error.h"
#include "engines/tiles/read/exemplar.h"
#include "engines/tiles/read/text.h"
#include "engines/tiles/write/vox.h"
#include "tests/tiles/folder.h"

namespace solitaire::tiles {
namespace {

std::string vox_error(const std::string& bytes) {
  try {
    Tileset tileset;
    read_vox("m.vox", bytes, tileset, true);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

/// A model of 2x2x2 with a tile that is named empty.
struct Tower {
  Tileset tileset;
  Grid map;

  Tower() {
    map = read_text("m", "ab\n..\n\nb.\n..\n", tileset, true);
    tileset[*tileset.find(".")].name = "empty";
  }
};

TEST_CASE("a map becomes a model of voxels and is read back") {
  const Tower tower;
  const std::string bytes = write_vox(tower.map, tower.tileset);
  Tileset voxels;
  const Grid again = read_vox("m.vox", bytes, voxels, true);
  REQUIRE(again.size == tower.map.size);
  for (std::size_t site = 0; site < again.tiles.size(); ++site) {
    const TileKind &before = tower.tileset[tower.map[site]], &after = voxels[again[site]];
    CHECK((before.name == "empty") == (after.name == "empty"));
    if (before.name != "empty") CHECK(before.color == after.color);
  }
  CHECK(write_vox(again, voxels) == bytes);
  CHECK(read_vox("m.vox", bytes, voxels, false) == again);
}

/// A model of 2x2x2 with one voxel, in the lower layer, up and to the right on the page.
VoxelModel corner() {
  VoxelModel model(Size{{2, 2, 2}});
  model.colors[model.size.site({1, 0, 0})] = 7;
  return model;
}

TEST_CASE("models of voxels are turned clockwise and mirrored left to right") {
  const VoxelModel model = corner();
  CHECK(turned(model).at({1, 1, 0}) == 7);
  CHECK(mirrored(model).at({0, 0, 0}) == 7);
  CHECK(turned(turned(turned(turned(model)))) == model);
  CHECK(mirrored(mirrored(model)) == model);
  VoxelModel bar(Size{{3, 1, 2}});
  bar.colors[bar.size.site({2, 0, 1})] = 1;
  CHECK(turned(bar).size == Size{{1, 3, 2}});
  CHECK(turned(bar).at({0, 2, 1}) == 1);
}

TEST_CASE("a map of tiles that are models is written as one model, each at its site") {
  Tileset tileset;
  TileKind empty, green;
  empty.name = "empty", green.name = "green";
  empty.voxels = std::make_shared<const VoxelModel>(Size{{2, 2, 2}});
  VoxelModel model = corner();
  model.palette.at(7) = Rgba{0, 200, 0, 255};
  green.voxels = std::make_shared<const VoxelModel>(model);
  for (const TileKind& kind : {empty, green}) tileset.add(kind);
  Grid map(Size{{3, 2, 1}}, 0);
  map[map.size.site({1, 1, 0})] = 1;
  map[map.size.site({2, 0, 0})] = kHole;
  const VoxelModel whole = read_voxel_model("m.vox", write_vox(map, tileset));
  CHECK(whole.size == Size{{6, 4, 2}});
  CHECK(whole.color(7) == Rgba{0, 200, 0, 255});
  for_each_point(whole.size, [&](const Point& at) { CHECK(whole.at(at) == (at == Point{3, 2, 0} ? 7 : 0)); });
  CHECK_THROWS_AS(write_vox(Grid(Size{{129, 1, 1}}, 0), tileset), std::length_error);
}

TEST_CASE("models in one file are exemplars each, with the file's palette") {
  const TestFolder folder("solitaire-vox-");
  VoxelModel model = corner();
  model.palette.at(7) = Rgba{1, 2, 3, 255};
  const std::string bytes = write_vox(model);
  const std::size_t first = bytes.find("SIZE"), after = bytes.find("RGBA");
  const std::string both = bytes.substr(0, after) + bytes.substr(first, after - first) + bytes.substr(after);
  Tileset tileset;
  const std::vector<Grid> grids = read_exemplars(folder.write("two.vox", both), 1, tileset, true);
  REQUIRE(grids.size() == 2);
  CHECK(grids[0] == grids[1]);
  CHECK(tileset.size() == 2);
  CHECK(tileset[*tileset.find("voxel 7")].color == Rgba{1, 2, 3, 255});
  CHECK_THROWS_AS(read_exemplar(folder.path() / "two.vox", 1, tileset, true), FileError);
}

TEST_CASE("mistakes in models of voxels are told") {
  const Tower tower;
  const std::string whole = write_vox(tower.map, tower.tileset);
  CHECK(vox_error("VOY ") == "m.vox: is no model of MagicaVoxel");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CAPTURE(length);
    const std::string error = vox_error(whole.substr(0, length));
    if (length != whole.find("RGBA")) CHECK(error.starts_with("m.vox: "));  // the palette need not be there
  }
  const auto changed = [&](std::size_t at, char byte) {
    std::string bytes = whole;
    bytes[at] = byte;
    return vox_error(bytes);
  };
  const std::size_t size = whole.find("SIZE") + 12, voxels = whole.find("XYZI") + 12;
  CHECK(changed(size + 3, '\x7f') == "m.vox: has a size that cannot be");
  CHECK(changed(voxels + 3, '\x7f') == "m.vox: ends too early");
  // A size belongs to the voxels that follow it.
  const std::string size_chunk = whole.substr(size - 12, 24), voxel_chunk = whole.substr(voxels - 12);
  CHECK(vox_error(whole + size_chunk) == "m.vox: has a size without voxels");
  CHECK(vox_error(whole + voxel_chunk) == "m.vox: has voxels before their size");
  CHECK(vox_error(whole + size_chunk + voxel_chunk) ==
        "m.vox: has several models; save each to a file of its own");
  CHECK(changed(voxels + 4, '\x09').ends_with("outside of its size"));
}

}  // namespace
}  // namespace solitaire::tiles
