#pragma once
#include <string>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Writes a map as a model of MagicaVoxel: the model of each tile at its site, or, if tiles have none, a
/// voxel for each, as read_vox() reads it. A tile that has no colour number of its own gets a free one; the
/// tile "empty" and holes are left out. Throws std::length_error for more than 256 voxels along an axis.
std::string write_vox(const Grid& map, const Tileset& tileset);

/// Writes a model.
std::string write_vox(const VoxelModel& model);

}  // namespace solitaire::tiles
