#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engines/tiles/job/job_options.h"

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
  std::filesystem::path checked;  // a map that is to be checked
  std::filesystem::path learned;  // where the weights are to be written
  bool explained = false, counted = false;
};

/// Adds the options of `solitaire tiles`.
void add_tiles_options(CLI::App& command, Options& options);

}  // namespace solitaire::app
