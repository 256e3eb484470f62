#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engines/tiles/request/request.h"
#include "engines/tiles/sample/sampler_options.h"

namespace solitaire::tiles {

/// What somebody asks for in a few words, above what a problem file says.
struct JobOptions {
  std::vector<std::string> inputs;  // exemplars, or one problem file (.tiles.json)
  bool debroglie = false;           // the input is a configuration file of DeBroglie
  std::optional<int> width, height, depth;
  bool periodic_x = false, periodic_y = false;
  std::optional<int> tile_side;
  std::optional<SymmetryGroup> symmetry;  // of exemplars
  std::optional<WeightsKind> weights;
  std::vector<std::string> pins;       // X,Y=TILE or X,Y:X,Y=TILE|TILE
  std::vector<std::string> connected;  // TILE,TILE
  SamplerOptions sampling;
  std::filesystem::path from;  // a map of which a part is kept
  std::string redo;            // what of it is made anew: the box X,Y:X,Y, or a .png whose light parts are
  std::vector<std::filesystem::path> pin_maps;  // maps of Tiled with pins
  std::vector<std::string> chunks;  // regions of an endless map, X,Y in chunks; then `maps` is as many
  std::uint64_t maps = 1;
  std::uint64_t jobs = 1;  // maps made at a time
};

}  // namespace solitaire::tiles
