#include "engines/tiles/write/vox.h"

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

/// Returns the model that tiles have which have one; they are all as large.
const VoxelModel* some_model(const Tileset& tileset) {
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    if (const auto& voxels = tileset[static_cast<Tile>(tile)].voxels) return voxels.get();
  }
  return nullptr;
}

/// Returns the models by tile: their own, or a single voxel where no tile has one.
std::vector<VoxelModel> models_of(const Tileset& tileset) {
  const VoxelModel* const some = some_model(tileset);
  const std::vector<std::uint8_t> numbers = color_numbers(tileset);
  std::vector<VoxelModel> models;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const TileKind& kind = tileset[static_cast<Tile>(tile)];
    if (some != nullptr) {
      models.push_back(kind.voxels ? *kind.voxels : VoxelModel(some->size));
    } else {
      models.emplace_back(Size());
      models.back().colors[0] = numbers[tile];
      if (numbers[tile] != 0) models.back().palette.at(numbers[tile]) = kind.color;
    }
  }
  return models;
}

void add_colors(const VoxelModel& model, VoxelModel::Palette& palette) {
  for (const std::uint8_t number : model.colors) {
    if (number != 0) palette.at(number) = model.color(number);
  }
}

/// Returns the map as one model, in which each tile's stands at its site.
VoxelModel model_of(const Grid& map, const Tileset& tileset) {
  const std::vector<VoxelModel> models = models_of(tileset);
  const Size block = models.empty() ? Size() : models.front().size;
  Size size;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    size.extent[axis] = map.size.extent[axis] * block.extent[axis];
    if (size.extent[axis] > kLongestSide || map.size.extent[axis] > kLongestSide)
      throw std::length_error("a .vox model has at most 256 voxels along each axis");
  }
  VoxelModel whole(size);
  for (const VoxelModel& model : models) add_colors(model, whole.palette);
  for_each_point(size, [&](const Point& at) {
    Point site, within;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      site[axis] = at[axis] / block.extent[axis];
      within[axis] = at[axis] % block.extent[axis];
    }
    const Tile tile = map.at(site);
    if (tile != kHole) whole.colors[size.site(at)] = models[tile].at(within);
  });
  return whole;
}

std::string palette_of(const VoxelModel& model) {
  std::string palette(1024, '\0');
  for (std::size_t number = 1; number < model.palette.size(); ++number) {
    if (!model.palette.at(number)) continue;
    for (std::size_t channel = 0; channel < 4; ++channel)
      palette[4U * (number - 1U) + channel] = static_cast<char>((*model.palette.at(number))[channel]);
  }
  return palette;
}

}  // namespace

std::string write_vox(const Grid& map, const Tileset& tileset) { return write_vox(model_of(map, tileset)); }

std::string write_vox(const VoxelModel& model) {
  std::string size, voxels;
  for (const int extent : model.size.extent) append_word(size, static_cast<std::size_t>(extent));
  std::size_t count = 0;
  for_each_point(model.size, [&](const Point& at) {
    if (model.at(at) == 0) return;
    ++count;
    for (const int place : {at[0], model.size.height() - 1 - at[1], at[2]})
      voxels += static_cast<char>(place);
    voxels += static_cast<char>(model.at(at));
  });
  std::string content, counted;
  append_word(counted, count);
  append_chunk(content, "SIZE", size);
  append_chunk(content, "XYZI", counted + voxels);
  append_chunk(content, "RGBA", palette_of(model));
  std::string file = "VOX ";
  append_word(file, 150);
  file += "MAIN";
  append_word(file, 0);
  append_word(file, content.size());
  return file + content;
}

}  // namespace solitaire::tiles
