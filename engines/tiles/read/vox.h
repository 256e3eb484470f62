#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Reads the models in a file of MagicaVoxel, at least one; all have the file's palette. The file has z
/// upwards and y into the depth, where maps have y down the page. Throws FileError.
std::vector<VoxelModel> read_voxel_models(const std::string& name, std::string_view bytes);

/// Reads a file of one model. Throws FileError.
VoxelModel read_voxel_model(const std::string& name, std::string_view bytes);

/// Returns a model as a map: a colour of its palette is a tile, named "voxel 7" by its number; what is empty
/// is the tile "empty". New tiles are added to an open tileset. Throws FileError.
Grid grid_of(const std::string& name, const VoxelModel& model, Tileset& tileset, bool open);

/// Reads a file of one model as a map. Throws FileError.
Grid read_vox(const std::string& name, std::string_view bytes, Tileset& tileset, bool open);

}  // namespace solitaire::tiles
