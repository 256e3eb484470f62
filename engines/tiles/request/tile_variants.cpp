#include "engines/tiles/request/tile_variants.h"

#include <fmt/format.h>
#include <utility>

#include "engines/tiles/model/edge_label.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/tiled/gid_flags.h"

namespace solitaire::tiles {
namespace {

// The sides of a flat tile in the order of TileKind::edges.
enum : std::size_t { kRight, kLeft, kBottom, kTop };

Picture turned(const Picture& icon) {
  Picture result(icon.height, icon.width);
  for (int y = 0; y < icon.height; ++y) {
    for (int x = 0; x < icon.width; ++x) result.at(icon.height - 1 - y, x) = icon.at(x, y);
  }
  return result;
}

Picture mirrored(const Picture& icon) {
  Picture result(icon.width, icon.height);
  for (int y = 0; y < icon.height; ++y) {
    for (int x = 0; x < icon.width; ++x) result.at(icon.width - 1 - x, y) = icon.at(x, y);
  }
  return result;
}

/// Replaces the model of a tile by an image of it.
template <class Image>
void replace_voxels(TileKind& kind, Image image) {
  if (kind.voxels) kind.voxels = std::make_shared<const VoxelModel>(image(*kind.voxels));
}

/// Turns the gids of a tile of Tiled, and with them its name.
template <class Turn>
void turn_gids(TileKind& kind, Turn turn) {
  if (kind.parts.empty()) return;
  for (TiledPart& part : kind.parts) part.gid = part.gid == 0 ? 0 : turn(part.gid);
  kind.gid = kind.parts.front().gid;
  kind.name = name_of_parts(kind.parts);
}

/// Says of each of several turned tiles which one it is after a further quarter.
void chain(std::vector<TileKind>& variants, std::size_t first, std::size_t turns) {
  for (std::size_t turn = 0; turn < turns; ++turn)
    variants[first + turn].turned = variants[first + (turn + 1) % turns].name;
}

void add_turns(const TileKind& kind, int turns, const std::string& prefix, std::vector<TileKind>& variants) {
  TileKind next = kind;
  for (int turn = 0; turn < turns; ++turn) {
    next.name = kind.name + prefix + (turn > 0 ? std::to_string(90 * turn) : "");
    variants.push_back(next);
    variants.back().bias = kind.bias;
    next = turned_kind(next);
    next.text.clear();  // a character stands for one tile
  }
}

}  // namespace

TileKind turned_kind(const TileKind& kind) {
  TileKind result = kind;
  result.icon = turned(kind.icon);
  result.edges[kRight] = kind.edges[kTop];
  result.edges[kBottom] = kind.edges[kRight];
  result.edges[kLeft] = kind.edges[kBottom];
  result.edges[kTop] = kind.edges[kLeft];
  result.turn = (kind.turn + 3) % 4;
  replace_voxels(result, [](const VoxelModel& model) { return turned(model); });
  turn_gids(result, turned_gid);
  return result;
}

TileKind mirrored_kind(const TileKind& kind) {
  TileKind result = kind;
  result.icon = mirrored(kind.icon);
  std::swap(result.edges[kRight], result.edges[kLeft]);
  for (std::string& label : result.edges) label = reversed_label(label);
  replace_voxels(result, [](const VoxelModel& model) { return mirrored(model); });
  turn_gids(result, mirrored_gid);
  return result;
}

std::vector<TileKind> variants_of(const TileKind& kind, const std::string& symmetry) {
  static const std::string kLetters = "XI\\TLF";
  static constexpr int kTurns[] = {1, 2, 2, 4, 4, 4};
  std::vector<TileKind> variants;
  if (symmetry.empty()) return {kind};
  const std::size_t letter = kLetters.find(symmetry);
  if (symmetry.size() != 1 || letter == std::string::npos) {
    throw RequestError(
        fmt::format("'{}' has the symmetry '{}'; X, I, \\, T, L and F are", kind.name, symmetry));
  }
  add_turns(kind, kTurns[letter], "!", variants);
  variants.front().name = kind.name;
  chain(variants, 0, variants.size());
  if (symmetry == "X" || symmetry == "I") {
    for (TileKind& each : variants) each.mirrored = each.name;
  }
  if (symmetry == "F") {
    if (!kind.asset.empty()) {
      throw RequestError(
          fmt::format("the model of '{}' cannot be mirrored; give it no symmetry F", kind.name));
    }
    TileKind image = mirrored_kind(kind);
    image.text.clear();
    add_turns(image, 4, "!x", variants);
    chain(variants, 4, 4);
  }
  return variants;
}

}  // namespace solitaire::tiles
