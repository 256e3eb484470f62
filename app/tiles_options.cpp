#include "app/tiles_options.h"

#include <CLI/CLI.hpp>

#include "app/one_of.h"
#include "app/options.h"

namespace solitaire::app {
namespace {

using tiles::SamplerKind;
using tiles::WeightsKind;

/// Maps and sweeps are no more than that.
constexpr int kMostRounds = 1'000'000'000;

void add_map_options(CLI::App& command, tiles::JobOptions& options) {
  const auto extent = CLI::Range(1, 1 << 20);
  command.add_option("-W,--width", options.width, "sites from left to right (default 20)")->check(extent);
  command.add_option("-H,--height", options.height, "sites from top to bottom (default 20)")->check(extent);
  command.add_option("-D,--depth", options.depth, "layers (default 1)")->check(extent);
  command.add_flag("--periodic-x", options.periodic_x, "the right side meets the left side");
  command.add_flag("--periodic-y", options.periodic_y, "the bottom meets the top");
  command
      .add_option(
          "--pin", options.pins,
          "fix a site, or a box of sites: X,Y=TILE or X,Y:X,Y=TILE|TILE, counted from 0 at the left and "
          "the top, or from -1 at the right and the bottom; can be given several times")
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("X,Y=TILE");
  command
      .add_option("--connected", options.connected,
                  "these tiles form one network, of which every tile can be reached: floor,door")
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("TILE,...");
  command.add_option("--from", options.from, "a map to start from; say with --redo what is made anew");
  command
      .add_option(
          "--redo", options.redo,
          "what of --from is made anew, the rest stays: a box, or a .png over the map whose light parts are")
      ->type_name("X,Y:X,Y|FILE.png");
  command
      .add_option(
          "--pins", options.pin_maps,
          "a map of Tiled (.tmx, .tmj) whose object layer \"pins\" has rectangles named TILE or TILE|TILE")
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("FILE");
  command
      .add_option(
          "--chunk", options.chunks,
          "make this chunk of an endless map, as wide and high as -W and -H say, whose neighbours are those "
          "of the same seed: 12,-3; can be given several times")
      ->allow_extra_args(false)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("X,Y");
}

void add_learning_options(CLI::App& command, tiles::JobOptions& options) {
  command.add_option("--tile", options.tile_side, "pixels along a side of a tile in PNG files (default 1)")
      ->check(CLI::Range(1, 1024));
  command
      .add_option_function<std::string>(
          "--symmetry",
          [&options](const std::string& name) { options.symmetry = tiles::symmetry_named(name); },
          "exemplars count in these orientations, too: mirror (left to right), 4 (turned), or 8 (turned "
          "and mirrored); a tile without such an image leaves a hole (default none)")
      ->check(CLI::IsMember({"none", "mirror", "4", "8"}))
      ->type_name("none|mirror|4|8");
  command
      .add_option(
          "--weights", options.weights,
          "fitted (default): patches become about as frequent as in the exemplars; step: a patch that an "
          "exemplar has weighs 1 + epsilon")
      ->transform(one_of<WeightsKind>({{"fitted", WeightsKind::kFitted}, {"step", WeightsKind::kStep}}));
}

void add_sampler_options(CLI::App& command, tiles::JobOptions& options) {
  static const Words<SamplerKind> kSamplers{
      {"windows", SamplerKind::kWindows}, {"blockss", SamplerKind::kBlockSs}, {"wfc", SamplerKind::kWfc},
      {"raster", SamplerKind::kRaster},   {"mh", SamplerKind::kMh},           {"gibbs", SamplerKind::kGibbs},
      {"search", SamplerKind::kSearch}};
  command
      .add_option("--sampler", options.sampling.kind,
                  "windows (default, exact), blockss (Yeh et al. 2012), wfc, raster, mh, gibbs or search, to "
                  "compare with")
      ->transform(one_of(kSamplers));
  command
      .add_option("--anneal", options.sampling.anneal,
                  "windows: sweeps in which the weights grow to their full strength (default 80)")
      ->check(CLI::Range(0, kMostRounds));
  command.add_option("--sweeps", options.sampling.sweeps, "windows: sweeps after those (default 40)")
      ->check(CLI::Range(0, kMostRounds));
  command
      .add_option("--burn-in", options.sampling.burn_in,
                  "blockss: samples of the chain before the one that is taken (default 5)")
      ->check(CLI::Range(0, kMostRounds));
  command
      .add_option_function<std::string>(
          "--blockss-start",
          [&options](const std::string& start) { options.sampling.restart = start == "restart"; },
          "blockss: each search begins with random tiles (restart, default), or with the map before, as the "
          "paper "
          "prints it, which never moves (current)")
      ->check(CLI::IsMember({"restart", "current"}))
      ->type_name("restart|current");
  command
      .add_option("--blocks", options.sampling.largest_block,
                  "blockss: the set of block shapes, 1 to 6 (default 6)")
      ->check(CLI::Range(1, 6));
}

}  // namespace

void add_tiles_options(CLI::App& command, Options& options) {
  options.tiles = std::make_shared<TilesOptions>();
  TilesOptions& tiles_options = *options.tiles;
  tiles::JobOptions& job = tiles_options.job;
  command
      .add_option("exemplars", job.inputs,
                  "small maps to learn from (.txt, .png, .json, .tmx, .tmj, .vox), tilesets with terrains "
                  "(.tsx, .tsj), or "
                  "a problem file (.tiles.json)")
      ->required();
  command.add_flag("--debroglie", job.debroglie, "the file is a configuration of DeBroglie (.json)");
  add_map_options(command, job);
  add_learning_options(command, job);
  add_sampler_options(command, job);
  command.add_option("-n,--maps", job.maps, "how many maps (default 1)")->check(CLI::Range(0, kMostRounds));
  command.add_option("-o,--output", options.output, "the folder to write to (default out)");
  add_seed_option(command, job.sampling.seed, "another seed gives other maps");
  command.add_option("--jobs", job.jobs, "maps made at a time (default 1)")->check(CLI::Range(1, 256));
  command
      .add_option("--format", tiles_options.formats,
                  "txt, png, json, tmx, tmj, vox, glb, separated by commas (default txt,png)")
      ->delimiter(',')
      ->check(CLI::IsMember({"txt", "png", "json", "tmx", "tmj", "vox", "glb"}));
  command
      .add_option(
          "--nodes", tiles_options.nodes,
          "how tiles become nodes of .glb files: each; instances, for all that look alike one "
          "(EXT_mesh_gpu_instancing; default where a map has more than 20000 tiles); plain, the same "
          "without names (default from 200000); or chunks, for importers that know no instances: one for "
          "all that look alike in 32x32 tiles")
      ->transform(one_of<Nodes>({{"each", Nodes::kOneEach},
                                 {"instances", Nodes::kInstances},
                                 {"plain", Nodes::kPlainInstances},
                                 {"chunks", Nodes::kChunks}}));
  command
      .add_option("--pixels", tiles_options.pixels, "pixels of a tile without icon in .png files (default 8)")
      ->check(CLI::Range(1, 256));
  command.add_option(
      "--learn", tiles_options.learned,
      "write the weights to this .json file, for \"weights\" of a problem file; with -n 0 nothing else");
  command.add_option("--check", tiles_options.checked, "make nothing; say what is wrong with this map");
  command.add_flag("--explain", tiles_options.explained, "make nothing; say why there is no map");
  command.add_flag("--count", tiles_options.counted, "make nothing; say how many maps there are");
  add_limit_options(command, options);
  command.add_flag("-q,--quiet", options.quiet, "no summary");
}

}  // namespace solitaire::app
