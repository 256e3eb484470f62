#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/console.h"
#include "app/earlier_run.h"
#include "app/marking.h"
#include "app/run_manifest.h"
#include "app/search.h"
#include "app/solution_json.h"
#include "base/file_error.h"
#include "scene/assets.h"
#include "scene/atomic_file.h"
#include "scene/gallery.h"
#include "scene/gltf.h"
#include "scene/plan.h"
#include "scene/scene.h"

namespace solitaire {
namespace {

const char* solver_name(Backend backend) {
  switch (backend) {
    case Backend::kCadical:
      break;
    case Backend::kZ3:
      return "z3";
    case Backend::kThesis:
      return "thesis";
  }
  return "cadical";
}

std::string engine_name(const Options& options) {
  const bool uniform = options.sampling == Sampling::kUniform;
  return fmt::format("{}/{}", uniform ? "uniform" : "tracing", solver_name(options.backend));
}

/// How much of a solution's value the gallery shows.
constexpr std::size_t kShownValue = 400;

std::string shortened(std::string text) {
  if (text.size() <= kShownValue) return text;
  std::size_t end = kShownValue;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    --end;  // not within a character
  return text.substr(0, end) + " …";
}

nlohmann::ordered_json timings_json(const TracingTimes& times) {
  return {{"explore", times.explore},
          {"encode", times.encode},
          {"solve", times.solve},
          {"replay", times.replay},
          {"replays", times.replays}};
}

/// Writes a solution's files as it is found, and at the end the page that shows them all.
class Output {
 public:
  Output(const Session& session, const Options& options)
      : session_(session), options_(options), assets_(data_folder() / "assets", session.program().folder()) {
    std::error_code error;
    std::filesystem::create_directories(options.output, error);
    if (!std::filesystem::is_directory(options.output)) {
      throw FileError(options.output.string(), error ? error.message() : "is not a folder");
    }
    remove_abandoned_files(options.output);
  }

  /// Writes a solution's files.
  void add(std::uint64_t number, const Solution& solution, const TracingTimes& times) {
    GalleryEntry entry = entry_of(number, solution);
    if (const auto scene = scene_of(entry, solution)) write_glb(*scene, options_.output / entry.glb);
    // The last of the files: where it is, the others are.
    write_file_atomically(options_.output / entry.json, json(entry.name, number, solution, times));
    entries_.push_back(std::move(entry));
    diversity_.add(solution);
    times_ = times;
  }

  /// Takes up a solution whose files are there.
  void add_earlier(std::uint64_t number, const Solution& solution) {
    GalleryEntry entry = entry_of(number, solution);
    scene_of(entry, solution);
    entries_.push_back(std::move(entry));
    diversity_.add(solution);
  }

  /// What the .json files of this run have in common.
  nlohmann::ordered_json run() const {
    nlohmann::ordered_json run{{"program", std::filesystem::path(options_.script).filename().string()},
                               {"params", nlohmann::ordered_json::object()},
                               {"seed", options_.seed},
                               {"engine", engine_name(options_)}};
    for (const auto& [param, value] : session_.params())
      run["params"][param] = nlohmann::ordered_json::parse(to_json(value));
    return run;
  }

  /// Writes what there is to say about the run as a whole.
  void close(std::optional<Ending> ending) const {
    if (!entries_.empty()) {
      const std::filesystem::path page = options_.output / "index.html";
      write_file_atomically(page, gallery());
      if (!options_.quiet) tell(fmt::format("see {}\n", page.string()));
    }
    nlohmann::ordered_json manifest{{"name", session_.name()}, {"version", SOLITAIRE_VERSION}};
    manifest.update(run());
    manifest.update(run_manifest(options_, diversity_, ending));
    if (options_.timings) manifest["timings"] = timings_json(times_);
    write_file_atomically(options_.output / (session_.name() + "-run.json"), json_text(manifest, 1) + "\n");
  }

 private:
  GalleryEntry entry_of(std::uint64_t number, const Solution& solution) const {
    GalleryEntry entry;
    entry.index = number;
    entry.name = fmt::format("{}-{:04}", session_.name(), number);
    entry.json = entry.name + ".json";
    entry.choices = solution.choices.size();
    if (!solution.execution.value.is<Value::Nil>())
      entry.value = shortened(to_text(solution.execution.value));
    entry.remarks.push_back(quality_text(solution));
    for (const Rejection& broken : solution.execution.broken)
      entry.remarks.push_back("broken: " + broken_text(broken, session_.program().sources));
    return entry;
  }

  /// The solution's scene, nothing if it places nothing; its plan goes into the entry.
  std::optional<Scene> scene_of(GalleryEntry& entry, const Solution& solution) {
    if (solution.execution.placements.empty()) return std::nullopt;
    entry.glb = entry.name + ".glb";
    Scene scene = build_scene(marked_placements(solution, session_.program().sources),
                              solution.execution.unit, entry.name, assets_);
    entry.plan = svg_plan(scene);
    return scene;
  }

  std::string gallery() const {
    GalleryInfo info{session_.name(),
                     std::filesystem::path(options_.script).filename().string(),
                     std::to_string(options_.seed),
                     {}};
    for (const std::string& setting : options_.settings) {
      const std::size_t sign = setting.find('=');
      info.options.emplace_back(setting.substr(0, sign), setting.substr(sign + 1));
    }
    if (diversity_.solutions() > 1) {
      info.options.emplace_back("mean distance of choices", fmt::format("{:.2f}", diversity_.of_choices()));
      info.options.emplace_back("of results", fmt::format("{:.2f}", diversity_.of_results()));
    }
    return gallery_html(info, entries_);
  }

  std::string json(const std::string& name, std::uint64_t number, const Solution& solution,
                   const TracingTimes& times) const {
    nlohmann::ordered_json file{{"name", name}, {"index", number}};
    file.update(run());
    file.update(solution_json(solution, session_.program().sources));
    if (options_.timings) file["timings"] = timings_json(times);
    return json_text(file, 1) + "\n";
  }

  const Session& session_;
  const Options& options_;
  AssetLibrary assets_;
  Diversity diversity_;
  TracingTimes times_;  // as of the last solution: the engine may be at work
  std::vector<GalleryEntry> entries_;
};

/// Takes up the run that left its solutions in the folder.
void resume(Search& search, Output& output, const Session& session, const Options& options) {
  const std::vector<EarlierSolution> earlier = read_earlier_run(options.output, session.name(), output.run());
  std::vector<KnownChoices> choices;
  for (const EarlierSolution& each : earlier) choices.push_back(each.choices);
  try {
    search.resume(choices, [&](std::uint64_t number, const Solution& solution) {
      Solution known = solution;
      const auto& optimal = earlier[number - 1].optimal;
      if (known.quality && optimal) known.quality->proved = *optimal;
      output.add_earlier(number, known);
    });
  } catch (const NotASolution& error) {
    throw FileError(options.output.string(),
                    fmt::format("{}; has the program changed? Generate into another folder", error.what()));
  }
}

}  // namespace

ExitStatus generate(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  Search search(session, options, watchdog, SceneDetail::kProvenance);
  Output output(session, options);
  if (options.resume) resume(search, output, session, options);
  return search.run(
      [&](std::uint64_t number, const Solution& solution) {
        output.add(number, solution, search.times());
        if (solution.quality && !options.quiet)
          tell(fmt::format("{}-{:04}: {}\n", session.name(), number, quality_text(solution)));
        if (!options.json) return;
        print_result(solution_line(number, solution, session.program().sources));
      },
      [&](std::optional<Ending> ending) { output.close(ending); });
}

}  // namespace solitaire
