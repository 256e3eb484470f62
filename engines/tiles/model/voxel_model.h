#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engines/tiles/model/grid.h"
#include "engines/tiles/model/picture.h"

namespace solitaire::tiles {

/// A block of coloured cubes, as MagicaVoxel has them. As in maps, y goes down the page.
struct VoxelModel {
  using Palette = std::array<std::optional<Rgba>, 256>;  // the colour of a number, if it is said

  Size size;
  std::vector<std::uint8_t> colors;  // the number of the colour at each site; 0 is empty
  Palette palette{};

  VoxelModel() : colors(1) {}
  explicit VoxelModel(Size of) : size(of), colors(of.volume()) {}

  std::uint8_t at(const Point& at) const { return colors[size.site(at)]; }
  Rgba color(std::uint8_t number) const;
  friend bool operator==(const VoxelModel&, const VoxelModel&) = default;
};

/// Returns the model turned by a quarter, clockwise as the page shows it.
VoxelModel turned(const VoxelModel& model);
/// Returns its mirror image, left to right.
VoxelModel mirrored(const VoxelModel& model);
/// Returns what is seen of it from above.
Picture seen_from_above(const VoxelModel& model);
/// Returns the colours of the first or the last layer across an axis.
std::vector<std::uint8_t> layer_of(const VoxelModel& model, std::size_t axis, bool last);

}  // namespace solitaire::tiles
