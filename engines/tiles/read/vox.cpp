#include "engines/tiles/read/vox.h"

#include <array>
#include <fmt/format.h>
#include <optional>
#include <stdexcept>

#include "base/file_error.h"
#include "engines/tiles/model/palette.h"

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

/// Collects the chunks of one model.
class VoxReader {
 public:
  VoxReader(const std::string& name, Tileset& tileset, bool open)
      : name_(name), tileset_(tileset), open_(open) {}

  Grid read(std::string_view bytes) {
    VoxBytes file(name_, bytes);
    if (bytes.size() < 4 || file.take(4) != "VOX ") throw FileError(name_, "is no model of MagicaVoxel");
    file.word();  // the version: what is read here is the same in all of them
    while (!file.empty()) read_chunk(file);
    if (!voxels_) throw FileError(name_, "has no voxels");
    return grid();
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

  /// What comes after the voxels of a model belongs to another one.
  void require_one_model() const {
    if (voxels_) throw FileError(name_, "has several models; save each to a file of its own");
  }

  void read_size(VoxBytes& chunk) {
    require_one_model();
    for (int& extent : size_.extent) {
      const std::uint32_t length = chunk.word();
      if (length < 1 || length > kLongestSide) throw FileError(name_, "has a size that cannot be");
      extent = static_cast<int>(length);
    }
    if (size_.volume() > kMostSites) throw FileError(name_, "is too large");
    has_size_ = true;
  }

  void read_voxels(VoxBytes& chunk) {
    require_one_model();
    if (!has_size_) throw FileError(name_, "has voxels before their size");
    voxels_.emplace(size_.volume());
    for (std::uint32_t left = chunk.word(); left > 0; --left) {
      const int x = chunk.byte(), y = chunk.byte(), z = chunk.byte();
      const std::uint8_t color = chunk.byte();
      if (x >= size_.width() || y >= size_.height() || z >= size_.depth()) {
        throw FileError(name_, fmt::format("has a voxel at ({},{},{}), outside of its size", x, y, z));
      }
      (*voxels_)[size_.site({x, size_.height() - 1 - y, z})] = color;
    }
  }

  void read_palette(VoxBytes& chunk) {
    for (std::size_t color = 1; color < palette_.size(); ++color) {
      Rgba rgba;
      for (std::uint8_t& channel : rgba) channel = chunk.byte();
      palette_[color] = rgba;
    }
  }

  Grid grid() {
    std::array<std::optional<Tile>, 256> tiles;
    Grid grid(size_);
    for (std::size_t site = 0; site < voxels_->size(); ++site) {
      const std::uint8_t color = (*voxels_)[site];
      if (!tiles[color]) tiles[color] = tile_of(color);
      grid[site] = *tiles[color];
    }
    return grid;
  }

  Tile tile_of(std::uint8_t color) {
    const std::string name = color == 0 ? "empty" : fmt::format("voxel {}", color);
    for (std::size_t tile = 0; tile < tileset_.size(); ++tile) {
      const TileKind& kind = tileset_[static_cast<Tile>(tile)];
      if (kind.voxel ? *kind.voxel == color : kind.name == name) return static_cast<Tile>(tile);
    }
    if (!open_) throw FileError(name_, fmt::format("has '{}', which is no tile of the tileset", name));
    TileKind kind;
    kind.name = name;
    kind.voxel = color;
    kind.color = color == 0 ? Rgba{} : palette_[color] ? *palette_[color] : palette_color(color);
    try {
      return tileset_.add(std::move(kind));
    } catch (const std::length_error& error) {
      throw FileError(name_, error.what());
    }
  }

  const std::string& name_;
  Tileset& tileset_;
  bool open_;
  Size size_;
  bool has_size_ = false;
  std::optional<std::vector<std::uint8_t>> voxels_;
  std::array<std::optional<Rgba>, 256> palette_;
};

}  // namespace

Grid read_vox(const std::string& name, std::string_view bytes, Tileset& tileset, bool open) {
  return VoxReader(name, tileset, open).read(bytes);
}

}  // namespace solitaire::tiles
