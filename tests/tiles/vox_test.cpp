#include "engines/tiles/read/vox.h"

#include <doctest/doctest.h>

#include "base/file_error.h"
#include "engines/tiles/read/text.h"
#include "engines/tiles/write/vox.h"

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
  // A size that follows the voxels must not change what they were read for.
  const std::string size_chunk = whole.substr(size - 12, 24), voxel_chunk = whole.substr(voxels - 12);
  CHECK(vox_error(whole + size_chunk) == "m.vox: has several models; save each to a file of its own");
  CHECK(vox_error(whole + voxel_chunk).find("several models") != std::string::npos);
  CHECK(changed(voxels + 4, '\x09').ends_with("outside of its size"));
}

}  // namespace
}  // namespace solitaire::tiles
