#pragma once
#include <filesystem>
#include <vector>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Reads an exemplar by the ending of its name: .txt, .tmx, .tmj, .vox, .json, or .png in squares of
/// `side` pixels. What it has that is no tile yet becomes one, if the tileset is open. Throws FileError.
Grid read_exemplar(const std::filesystem::path& file, int side, Tileset& tileset, bool open);

/// The same, where a .vox file may have several models, each of which is an exemplar.
std::vector<Grid> read_exemplars(const std::filesystem::path& file, int side, Tileset& tileset, bool open);

}  // namespace solitaire::tiles
