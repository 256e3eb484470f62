#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "app/commands.h"
#include "app/console.h"
#include "app/report.h"
#include "app/signals.h"
#include "app/tiles_options.h"
#include "app/tiles_page.h"
#include "app/tiles_scene.h"
#include "base/installation.h"
#include "base/stop_signal.h"
#include "engines/tiles/job/job.h"
#include "engines/tiles/request/request_error.h"
#include "scene/assets.h"
#include "scene/atomic_file.h"
#include "scene/gltf/writer.h"

namespace solitaire::app {
namespace {

namespace fs = std::filesystem;

ExitStatus check_map(const tiles::Job& job, const fs::path& file) {
  const std::vector<std::string> faults = job.check(file);
  for (const std::string& fault : faults) print_result(fault + "\n");
  if (faults.empty()) print_result("the map keeps all rules\n");
  return faults.empty() ? kDelivered : kNoSolution;
}

ExitStatus count_maps(const tiles::Job& job) {
  const auto count = job.count();
  if (count) {
    print_result(*count + "\n");
    return kDelivered;
  }
  tell(
      "error: these maps cannot be counted: too much would have to be remembered; make the shorter side "
      "shorter\n");
  return kLimit;
}

ExitStatus explain_maps(const tiles::Job& job) {
  for (const std::string& warning : job.warnings()) print_result("note: " + warning + "\n");
  const auto rules = job.explain();
  if (!rules) {
    print_result("there are maps that keep all pairs and pins\n");
    return kDelivered;
  }
  if (rules->empty()) {
    print_result("no map of this size keeps the exemplars' pairs, whatever is pinned\n");
    return kNoSolution;
  }
  print_result(
      "these contradict each other by the exemplars' pairs; without any one of them there are maps:\n");
  for (const std::string& rule : *rules) print_result("  " + rule + "\n");
  return kNoSolution;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw std::runtime_error(
        fmt::format("{}: {}", folder.string(), error ? error.message() : "is not a folder"));
  }
  remove_abandoned_files(folder);
}

/// Returns the name of the files without number and ending.
std::string stem(const TilesOptions& options) {
  const std::string file = fs::path(options.job.inputs.front()).filename().string();
  return file.substr(0, file.find('.'));
}

/// Returns the name of a map's files without ending: town-0001, or town_12_-3 for a chunk.
std::string name_of_map(const TilesOptions& options, std::uint64_t number) {
  if (options.job.chunks.empty()) return fmt::format("{}-{:04}", stem(options), number);
  std::string chunk = options.job.chunks[number - 1];
  std::ranges::replace(chunk, ',', '_');
  return fmt::format("{}_{}", stem(options), chunk);
}

/// Importers choke on a node for each of a million tiles, and some know no instances.
constexpr std::size_t kMostSingleNodes = 20'000, kMostNamedInstances = 200'000;

Nodes nodes_of(const TilesOptions& options, std::size_t tiles) {
  return options.nodes.value_or(tiles > kMostNamedInstances ? Nodes::kPlainInstances
                                : tiles > kMostSingleNodes  ? Nodes::kInstances
                                                            : Nodes::kOneEach);
}

MapLook look_of(const tiles::Job& job, const Options& options, const std::string& name,
                AssetLibrary& assets) {
  MapLook look{name, job.shown_tiles(), job.file("png", options.tiles->pixels, options.output), std::nullopt};
  const bool is_asked_for = std::ranges::count(options.tiles->formats, "glb") > 0;
  const auto has_shape = [](const tiles::ShownTile& tile) {
    return !tile.asset.empty() || tile.model || tile.at[2] > 0;
  };
  if (is_asked_for || std::ranges::any_of(look.tiles, has_shape))
    look.scene = tiles_scene(look.tiles, name, assets);
  look.nodes = nodes_of(*options.tiles, look.tiles.size());
  return look;
}

/// Writes the map that is delivered, in the format that the file's name says.
void write_map(const tiles::Job& job, const Options& options, MapLook& look, const fs::path& file) {
  const std::string format = file.extension().string().substr(1);
  if (format == "glb") {
    look.glb = write_glb(*look.scene, file, look.nodes);
  } else if (format == "png") {
    write_file_atomically(file, look.png);
  } else {
    write_file_atomically(file, job.file(format, options.tiles->pixels, options.output));
  }
}

/// Says how making maps ended, of which `delivered` are written.
ExitStatus tell_ending(const tiles::Job& job, tiles::JobEnding ending, std::uint64_t delivered,
                       const Options& options) {
  if (!options.quiet && (ending == tiles::JobEnding::kDone || delivered > 0)) tell(job.summary());
  switch (ending) {
    case tiles::JobEnding::kStopped:
      return report_limit(options);
    case tiles::JobEnding::kNoMap:
      tell("there is no such map; --explain says why\n");
      return kNoSolution;
    case tiles::JobEnding::kGaveUp:
      tell(fmt::format("error: the sampler gave up on map {}; this is no proof that there is none\n",
                       delivered + 1));
      return kLimit;
    case tiles::JobEnding::kDone:
      break;
  }
  return kDelivered;
}

ExitStatus make_maps(tiles::Job& job, const Options& options, Watchdog& watchdog) {
  for (const std::string& format : options.tiles->formats) job.require_format(format);
  make_folder(options.output);
  TilesPage page(options, stem(*options.tiles));
  AssetLibrary assets(find_data_folder() / "assets",
                      fs::path(options.tiles->job.inputs.front()).parent_path());
  std::uint64_t delivered = 0;
  const tiles::JobEnding ending = job.run([&](std::uint64_t number) {
    const auto lock = watchdog.delivering();
    const std::string name = name_of_map(*options.tiles, number);
    MapLook look = look_of(job, options, name, assets);
    for (const std::string& format : options.tiles->formats)
      write_map(job, options, look, options.output / fmt::format("{}.{}", name, format));
    page.add(number, look);
    delivered = number;
  });
  const auto lock = watchdog.delivering();
  page.close();
  if (!options.quiet) {
    for (const std::string& note : assets.notes()) tell(note + "\n");
  }
  return watchdog.conclude(tell_ending(job, ending, delivered, options));
}

ExitStatus run_tiles(const Options& options, Watchdog& watchdog) {
  tiles::Job job(options.tiles->job, [] { return stop_source().token().stopped(); });
  if (!options.quiet) {
    for (const std::string& note : job.notes()) tell("note: " + note + "\n");
  }
  if (!options.tiles->checked.empty()) return check_map(job, options.tiles->checked);
  if (options.tiles->explained) return explain_maps(job);
  if (options.tiles->counted) return count_maps(job);
  if (!options.tiles->learned.empty()) write_file_atomically(options.tiles->learned, job.weights());
  if (options.tiles->job.maps == 0) return kDelivered;
  return make_maps(job, options, watchdog);
}

}  // namespace

/// Makes maps from exemplars, or answers a question about them.
ExitStatus tiles_command(const Options& options, Watchdog& watchdog) {
  ExitStatus status = kUsage;
  try {
    status = run_tiles(options, watchdog);
  } catch (const tiles::RequestError& error) {
    tell(fmt::format("error: {}\n", error.what()));
  } catch (const Interrupted&) {
    const auto lock = watchdog.delivering();
    return watchdog.conclude(report_limit(options));
  }
  const auto lock = watchdog.delivering();
  return watchdog.conclude(status);
}

}  // namespace solitaire::app
