#include "engines/tiles/request/listed_tiles.h"

#include <algorithm>
#include <fmt/format.h>

#include "engines/tiles/model/palette.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/read/png.h"
#include "engines/tiles/read/vox.h"
#include "engines/tiles/request/names.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/request/tile_variants.h"

namespace solitaire::tiles {
namespace {

std::shared_ptr<const VoxelModel> voxels_of(const TileEntry& entry) {
  if (entry.voxel_file.empty()) return nullptr;
  const std::string name = entry.voxel_file.string();
  return std::make_shared<const VoxelModel>(read_voxel_model(name, read_bytes(entry.voxel_file)));
}

/// Returns the icon of a tile: a file of its own, or a square of the picture of all icons; empty without one.
Picture icon_at(const Picture& icons, const TileEntry& entry, int side) {
  if (!entry.icon_file.empty()) return read_png(entry.icon_file.string(), read_bytes(entry.icon_file));
  if (!entry.icon) return {};
  const int left = (*entry.icon)[0] * side, top = (*entry.icon)[1] * side;
  if (left < 0 || top < 0 || left + side > icons.width || top + side > icons.height) {
    throw RequestError(fmt::format("the icon of '{}' is outside of the picture of icons", entry.name));
  }
  Picture icon(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) icon.at(x, y) = icons.at(left + x, top + y);
  }
  return icon;
}

/// Writes the labels of a tile's sides into its kind: first those that are the same for all other sides.
void add_edges(const TileEntry& entry, TileKind& kind) {
  for (const bool all : {true, false}) {
    for (const auto& [letter, label] : entry.edges) {
      if ((letter == "*") != all) continue;
      const Sides sides = all ? kFlatSides : sides_of(letter);
      for (std::size_t side = 0; side < kind.edges.size(); ++side) {
        if ((sides >> side & 1U) != 0) kind.edges[side] = label;
      }
    }
  }
}

TileKind kind_of(const TileEntry& entry, const Picture& icons, int side, std::size_t number) {
  TileKind kind;
  kind.name = entry.name;
  kind.text = entry.text;
  kind.bias = entry.bias;
  kind.voxel = entry.voxel;
  kind.asset = entry.asset;
  kind.turn = entry.turn;
  kind.height = entry.height;
  kind.rotates = entry.rotates;
  kind.turned = entry.turned;
  kind.mirrored = entry.mirrored;
  kind.voxels = voxels_of(entry);
  kind.icon = icon_at(icons, entry, side);
  if (kind.icon.empty() && kind.voxels) kind.icon = seen_from_above(*kind.voxels);
  kind.color = entry.color ? *entry.color : kind.icon.empty() ? palette_color(number) : mean_color(kind.icon);
  add_edges(entry, kind);
  return kind;
}

/// Tiles are drawn as squares that are all as large.
void require_one_size(const Tileset& tileset) {
  const TileKind* first = nullptr;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const TileKind& kind = tileset[static_cast<Tile>(tile)];
    if (kind.icon.empty()) continue;
    if (first == nullptr) first = &kind;
    if (kind.icon.width == first->icon.width && kind.icon.height == first->icon.width) continue;
    throw RequestError(fmt::format(
        "the icon of '{}' has {}x{} pixels, but that of '{}' {}x{}; all are squares of one size", kind.name,
        kind.icon.width, kind.icon.height, first->name, first->icon.width, first->icon.height));
  }
}

/// Refuses a colour that has the same number as another one before it: a file has one palette.
void add_palette(const TileKind& kind, VoxelModel::Palette& palette) {
  for (const std::uint8_t number : kind.voxels->colors) {
    const Rgba color = kind.voxels->color(number);
    if (palette.at(number).value_or(color) != color) {
      throw RequestError(
          fmt::format("the model of '{}' has another colour {} than models before it; all have one palette",
                      kind.name, number));
    }
    palette.at(number) = color;
  }
}

/// Models stand beside each other in one file, and above each other in scenes.
void require_fitting_models(const Tileset& tileset) {
  const TileKind& first = tileset[0];
  VoxelModel::Palette palette{};
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const TileKind& kind = tileset[static_cast<Tile>(tile)];
    if (!kind.voxels && !first.voxels) continue;
    if (!kind.voxels || !first.voxels)
      throw RequestError(fmt::format("of '{}' and '{}' one has a model of voxels; all tiles have one or none",
                                     first.name, kind.name));
    const Size &size = kind.voxels->size, &wanted = first.voxels->size;
    if (size.width() != size.height())
      throw RequestError(fmt::format("the model of '{}' stands on {}x{} voxels, which is no square",
                                     kind.name, size.width(), size.height()));
    if (!(size == wanted)) {
      throw RequestError(fmt::format("the model of '{}' has {} voxels, but that of '{}' {}; all are as large",
                                     kind.name, size_text(size), first.name, size_text(wanted)));
    }
    add_palette(kind, palette);
  }
}

}  // namespace

void add_listed_tiles(const Request& request, Tileset& tileset) {
  Picture icons;
  if (!request.icons.empty()) icons = read_png(request.icons.string(), read_bytes(request.icons));
  for (const TileEntry& entry : request.tiles) {
    said_at(entry.where, [&] {
      const TileKind kind = kind_of(entry, icons, request.side_of_tiles(), tileset.size());
      for (TileKind& variant : variants_of(kind, entry.symmetry)) {
        if (tileset.find(variant.name))
          throw RequestError(fmt::format("there are two tiles '{}'", variant.name));
        tileset.add(std::move(variant));
      }
    });
  }
  if (tileset.size() > 0) require_fitting_models(tileset);
  require_one_size(tileset);
}

void add_remarks(const Request& request, Tileset& tileset) {
  for (const RemarkEntry& entry : request.remarks) {
    said_at(entry.where, [&] {
      TileKind& kind = tileset[tile_called(tileset, entry.name)];
      const auto name_of = [&](const std::string& image) {
        return image.empty() ? "" : tileset[tile_called(tileset, image)].name;
      };
      kind.bias = entry.bias;
      kind.turned = name_of(entry.turned);
      kind.mirrored = name_of(entry.mirrored);
    });
  }
}

}  // namespace solitaire::tiles
