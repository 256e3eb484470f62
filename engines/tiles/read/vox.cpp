#include "engines/tiles/read/vox.h"

#include <array>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>

#include "base/file_error.h"

namespace solitaire::tiles {
namespace {

constexpr std::uint32_t kLongestSide = 256;  // of a model, by the format

/// Reads little-endian words and chunks, never beyond the end.
class VoxBytes {
 public:
  VoxBytes(const std::string& name, std::string_view bytes) : name_(name), rest_(bytes) {}

  bool empty() const { return rest_.empty(); }
  std::string_view take(std::size_t count) {
    if (count > rest_.size()) throw FileError(name_, "ends too early");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  std::uint32_t word() {
    std::uint32_t value = 0;
    const std::string_view bytes = take(4);
    for (std::size_t byte = 0; byte < 4; ++byte) {
      value |= std::uint32_t{static_cast<unsigned char>(bytes[byte])} << (8 * byte);
    }
    return value;
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(take(1)[0]); }

 private:
  const std::string& name_;
  std::string_view rest_;
};

/// Collects the chunks of models.
class VoxReader {
 public:
  explicit VoxReader(const std::string& name) : name_(name) {}

  std::vector<VoxelModel> read(std::string_view bytes) {
    VoxBytes file(name_, bytes);
    if (bytes.size() < 4 || file.take(4) != "VOX ") throw FileError(name_, "is no model of MagicaVoxel");
    file.word();  // the version: what is read here is the same in all of them
    while (!file.empty()) read_chunk(file);
    if (size_) throw FileError(name_, "has a size without voxels");
    if (models_.empty()) throw FileError(name_, "has no voxels");
    for (VoxelModel& model : models_) model.palette = palette_;
    return std::move(models_);
  }

 private:
  void read_chunk(VoxBytes& file) {
    const std::string id(file.take(4));
    const std::uint32_t content = file.word();
    file.word();  // the size of the chunks within, which follow in their turn
    VoxBytes chunk(name_, file.take(content));
    if (id == "SIZE") read_size(chunk);
    if (id == "XYZI") read_voxels(chunk);
    if (id == "RGBA") read_palette(chunk);
  }

  /// The size of the model whose voxels come next.
  void read_size(VoxBytes& chunk) {
    size_.emplace();
    for (int& extent : size_->extent) {
      const std::uint32_t length = chunk.word();
      if (length < 1 || length > kLongestSide) throw FileError(name_, "has a size that cannot be");
      extent = static_cast<int>(length);
    }
    volume_ += size_->volume();
    if (volume_ > kMostSites) throw FileError(name_, "is too large");
  }

  void read_voxels(VoxBytes& chunk) {
    if (!size_) throw FileError(name_, "has voxels before their size");
    VoxelModel model(*size_);
    for (std::uint32_t left = chunk.word(); left > 0; --left) {
      const int x = chunk.byte(), y = chunk.byte(), z = chunk.byte();
      const std::uint8_t color = chunk.byte();
      if (x >= size_->width() || y >= size_->height() || z >= size_->depth()) {
        throw FileError(name_, fmt::format("has a voxel at ({},{},{}), outside of its size", x, y, z));
      }
      model.colors[size_->site({x, size_->height() - 1 - y, z})] = color;
    }
    models_.push_back(std::move(model));
    size_.reset();
  }

  void read_palette(VoxBytes& chunk) {
    for (std::size_t color = 1; color < palette_.size(); ++color) {
      Rgba rgba;
      for (std::uint8_t& channel : rgba) channel = chunk.byte();
      palette_[color] = rgba;
    }
  }

  const std::string& name_;
  std::optional<Size> size_;
  std::size_t volume_ = 0;  // of all sizes
  std::vector<VoxelModel> models_;
  VoxelModel::Palette palette_{};
};

Tile tile_of(const std::string& name, const VoxelModel& model, std::uint8_t color, Tileset& tileset,
             bool open) {
  const std::string called = color == 0 ? "empty" : fmt::format("voxel {}", color);
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const TileKind& kind = tileset[static_cast<Tile>(tile)];
    if (kind.voxel ? *kind.voxel == color : kind.name == called) return static_cast<Tile>(tile);
  }
  if (!open) throw FileError(name, fmt::format("has '{}', which is no tile of the tileset", called));
  TileKind kind;
  kind.name = called;
  kind.voxel = color;
  kind.color = model.color(color);
  try {
    return tileset.add(std::move(kind));
  } catch (const std::length_error& error) {
    throw FileError(name, error.what());
  }
}

}  // namespace

std::vector<VoxelModel> read_voxel_models(const std::string& name, std::string_view bytes) {
  return VoxReader(name).read(bytes);
}

VoxelModel read_voxel_model(const std::string& name, std::string_view bytes) {
  std::vector<VoxelModel> models = read_voxel_models(name, bytes);
  if (models.size() > 1) throw FileError(name, "has several models; save each to a file of its own");
  return std::move(models.front());
}

Grid grid_of(const std::string& name, const VoxelModel& model, Tileset& tileset, bool open) {
  std::array<std::optional<Tile>, 256> tiles;
  Grid grid(model.size);
  for (std::size_t site = 0; site < model.colors.size(); ++site) {
    const std::uint8_t color = model.colors[site];
    if (!tiles[color]) tiles[color] = tile_of(name, model, color, tileset, open);
    grid[site] = *tiles[color];
  }
  return grid;
}

Grid read_vox(const std::string& name, std::string_view bytes, Tileset& tileset, bool open) {
  return grid_of(name, read_voxel_model(name, bytes), tileset, open);
}

}  // namespace solitaire::tiles
