#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engines/tiles/job/job_options.h"
#include "scene/gltf/instances.h"

namespace CLI {
class App;
}

namespace solitaire::app {

struct Options;

/// What the command line asks of `solitaire tiles`, beside what all subcommands share.
struct TilesOptions {
  tiles::JobOptions job;
  std::vector<std::string> formats{"txt", "png"};
  int pixels = 8;                 // of a tile without an icon
  std::optional<Nodes> nodes;     // of .glb files; nothing: one each, but for large maps
  std::filesystem::path checked;  // a map that is to be checked
  std::filesystem::path learned;  // where the weights are to be written
  bool explained = false, counted = false;
};

/// Adds the options of `solitaire tiles`.
void add_tiles_options(CLI::App& command, Options& options);

}  // namespace solitaire::app
