#include "engines/tiles/read/exemplar.h"

#include <fmt/format.h>

#include "engines/tiles/read/file.h"
#include "engines/tiles/read/json.h"
#include "engines/tiles/read/png.h"
#include "engines/tiles/read/text.h"
#include "engines/tiles/read/vox.h"
#include "engines/tiles/tiled/tileset_files.h"

namespace solitaire::tiles {

Grid read_exemplar(const std::filesystem::path& file, int side, Tileset& tileset, bool open) {
  const std::string ending = file.extension().string();
  const std::string name = file.string();
  if (ending == ".txt") return read_text(name, read_bytes(file), tileset, open);
  if (ending == ".png") return cut_tiles(name, read_png(name, read_bytes(file)), side, tileset, open);
  if (ending == ".tmx" || ending == ".tmj") return read_tiled(file, tileset, open);
  if (ending == ".vox") return read_vox(name, read_bytes(file), tileset, open);
  if (ending == ".json") return read_json(name, read_bytes(file), tileset, open);
  throw FileError(
      name, fmt::format("'{}' is no format of maps; .txt, .png, .tmx, .tmj, .vox and .json are", ending));
}

std::vector<Grid> read_exemplars(const std::filesystem::path& file, int side, Tileset& tileset, bool open) {
  if (file.extension() != ".vox") return {read_exemplar(file, side, tileset, open)};
  std::vector<Grid> grids;
  for (const VoxelModel& model : read_voxel_models(file.string(), read_bytes(file)))
    grids.push_back(grid_of(file.string(), model, tileset, open));
  return grids;
}

}  // namespace solitaire::tiles
