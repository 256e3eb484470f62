#pragma once
#include <array>
#include <string>
#include <vector>

#include "scene/assets.h"

namespace solitaire {

/// A cube of a model that consists of cubes of one size: x to the right, y into the depth, z up.
struct Voxel {
  std::array<int, 3> at{};  // in sides of a cube
  Color color{};
};

/// Returns an asset of cubes whose sides are `side` metres long; there is at least one. Its origin is that of
/// the cubes' places. Faces between two cubes are left out.
Asset voxel_asset(const std::string& name, const std::vector<Voxel>& voxels, double side);

}  // namespace solitaire
