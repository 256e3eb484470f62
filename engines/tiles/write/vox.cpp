#include "engines/tiles/write/vox.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace solitaire::tiles {
namespace {

constexpr int kLongestSide = 256;

void append_word(std::string& bytes, std::size_t value) {
  for (unsigned byte = 0; byte < 4; ++byte) bytes += static_cast<char>(value >> (8 * byte) & 0xffU);
}

void append_chunk(std::string& bytes, const char* id, const std::string& content) {
  bytes += id;
  append_word(bytes, content.size());
  append_word(bytes, 0);
  bytes += content;
}

/// Returns the colour number of each tile; 0 is empty.
std::vector<std::uint8_t> color_numbers(const Tileset& tileset) {
  std::set<std::uint8_t> taken{0};
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    taken.insert(tileset[static_cast<Tile>(tile)].voxel.value_or(0));
  }
  std::vector<std::uint8_t> numbers;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const TileKind& kind = tileset[static_cast<Tile>(tile)];
    std::uint8_t number = kind.voxel.value_or(0);
    if (!kind.voxel && kind.name != "empty") {
      while (taken.contains(number)) ++number;
      taken.insert(number);
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::string palette_of(const Tileset& tileset, const std::vector<std::uint8_t>& numbers) {
  std::string palette(1024, '\0');
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    if (numbers[tile] == 0) continue;
    const Rgba& color = tileset[static_cast<Tile>(tile)].color;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      palette[4U * (numbers[tile] - 1U) + channel] = static_cast<char>(color[channel]);
    }
  }
  return palette;
}

}  // namespace

std::string write_vox(const Grid& map, const Tileset& tileset) {
  if (std::ranges::any_of(map.size.extent, [](int extent) { return extent > kLongestSide; })) {
    throw std::length_error("a .vox model has at most 256 voxels along each axis");
  }
  const std::vector<std::uint8_t> numbers = color_numbers(tileset);
  std::string size, voxels;
  for (const int extent : map.size.extent) append_word(size, static_cast<std::size_t>(extent));
  std::size_t count = 0;
  for_each_point(map.size, [&](const Point& at) {
    const Tile tile = map.at(at);
    if (tile == kHole || numbers[tile] == 0) return;
    ++count;
    for (const int place : {at[0], map.size.height() - 1 - at[1], at[2]}) voxels += static_cast<char>(place);
    voxels += static_cast<char>(numbers[tile]);
  });
  std::string content, counted;
  append_word(counted, count);
  append_chunk(content, "SIZE", size);
  append_chunk(content, "XYZI", counted + voxels);
  append_chunk(content, "RGBA", palette_of(tileset, numbers));
  std::string file = "VOX ";
  append_word(file, 150);
  file += "MAIN";
  append_word(file, 0);
  append_word(file, content.size());
  return file + content;
}

}  // namespace solitaire::tiles
