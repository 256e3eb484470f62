#include <charconv>
#include <fmt/format.h>
#include <solitaire/output.h>
#include <solitaire/solitaire.h>

#include "library/choice_columns.h"
#include "library/folder_lock.h"
#include "library/program_state.h"
#include "library/run_manifest.h"
#include "library/scene_of.h"
#include "library/solution_file.h"
#include "library/translate.h"
#include "scene/assets.h"
#include "scene/atomic_file.h"
#include "scene/gltf/verify.h"
#include "scene/gltf/writer.h"
#include "scene/page/page_files.h"
#include "scene/picture/picture_files.h"

namespace solitaire::api {
namespace {

namespace fs = std::filesystem;

/// The page shows so many bytes of a solution's value.
constexpr std::size_t kShownValue = 400;
/// It sorts and filters by values of at most so many bytes of JSON.
constexpr std::size_t kComparedValue = 2000;

std::string shortened(const std::string& text) {
  if (text.size() <= kShownValue) return text;
  const auto within_character = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  std::size_t end = kShownValue;
  while (end > 0 && within_character(end)) --end;
  return text.substr(0, end) + " …";
}

/// Returns true if the file is there and shows the scene: it was neither removed nor cut short since.
bool is_written(const Scene& scene, const fs::path& file, Nodes nodes) {
  try {
    verify_glb(file, scene, nodes);
    return true;
  } catch (const SceneError&) {
    return false;
  }
}

/// Makes the folder ready for a run's files, and returns it.
const fs::path& made_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw Error(Error::Kind::kFile,
                fmt::format("{}: {}", folder.string(), error ? error.message() : "is not a folder"));
  }
  remove_abandoned_files(folder);
  return folder;
}

solitaire::Viewpoint viewpoint_of(Viewpoint from) {
  return from == Viewpoint::kEye ? solitaire::Viewpoint::kEye : solitaire::Viewpoint::kAbove;
}

}  // namespace

void write_glb(const Solution& solution, const Program& program, const std::string& title,
               const fs::path& path) {
  translated(program.state().program.sources, [&] {
    if (solution.placements.empty()) throw FileError(path.string(), "the solution places nothing");
    AssetLibrary assets = program.state().asset_library();
    solitaire::write_glb(scene_of(solution, title, assets), path);
  });
}

std::optional<PictureSize> parse_picture_size(const std::string& text) {
  solitaire::PictureSize size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  if (height.ec != std::errc() || height.ptr != end || !size.is_possible()) return std::nullopt;
  return PictureSize{size.width, size.height};
}

class OutputFolder::State {
 public:
  State(const fs::path& folder, const Program& program, const SearchOptions& options, bool timings,
        const std::optional<Pictures>& pictures, bool instancing)
      : folder_(folder),
        program_(program),
        options_(options),
        timings_(timings),
        nodes_(instancing ? Nodes::kInstances : Nodes::kOneEach),
        assets_(program.state().asset_library()),
        lock_(std::in_place, made_folder(folder)),
        page_(folder, program.state().data / "page") {
    if (pictures) {
      const solitaire::PictureSize size{pictures->size.width, pictures->size.height};
      pictures_.emplace(folder, size, options.jobs, viewpoint_of(pictures->from));
    }
  }

  void resume(Search& search) {
    const std::vector<EarlierSolution> earlier =
        read_earlier_run(folder_, program_.name(), run_json(program_, options_));
    std::vector<std::vector<Choice>> choices;
    for (const EarlierSolution& each : earlier) choices.push_back(each.choices);
    for (Solution& solution : run_again(search, choices)) {
      const EarlierSolution& known = earlier[solution.number - 1];
      if (solution.quality && known.optimal) solution.quality->proved_best = *known.optimal;
      if (solution.quality) solution.quality->least_cost = known.least_cost;
      GalleryEntry entry = entry_of(solution);
      const auto scene = scene_of_entry(entry, solution);
      if (scene && !is_written(*scene, folder_ / entry.glb, nodes_))
        solitaire::write_glb(*scene, folder_ / entry.glb, nodes_);
      if (scene && pictures_) entry.picture = pictures_->take_up(*scene, entry.name);
      show(std::move(entry), solution, scene, scene ? glb_bytes(*scene, nodes_) : "");
    }
    written_ = search.summary();
  }

  void add(const Solution& solution, const Summary& summary) {
    GalleryEntry entry = entry_of(solution);
    const auto scene = scene_of_entry(entry, solution);
    std::string glb;
    if (scene) {
      glb = solitaire::write_glb(*scene, folder_ / entry.glb, nodes_);
      if (pictures_) entry.picture = pictures_->draw(*scene, entry.name);
    }
    const std::string file = entry.json, text = json(entry.name, solution, summary);
    show(std::move(entry), solution, scene, glb);
    // The last of the files: where it is, the others are.
    write_file_atomically(folder_ / file, text);
    written_ = summary;
  }

  std::optional<fs::path> close(std::optional<Ending> ending, StopReason reason) {
    if (pictures_) pictures_->close();
    std::optional<fs::path> page;
    if (!entries_.empty()) {
      page = page_.close(gallery_info(), entries_, choices_.json());
    }
    Json manifest{{"name", program_.name()}, {"version", version()}};
    manifest.update(run_json(program_, options_));
    manifest.update(manifest_json(options_, written_, ending, reason));
    if (timings_) manifest["timings"] = timings_json(written_.times);
    write_file_atomically(folder_ / (program_.name() + "-run.json"), json_text(manifest, 1) + "\n");
    lock_.reset();
    return page;
  }

  std::vector<std::string> notes() const { return assets_.notes(); }
  const SourceSet& sources() const { return program_.state().program.sources; }

 private:
  std::vector<Solution> run_again(Search& search, const std::vector<std::vector<Choice>>& choices) const {
    try {
      return search.resume(choices);
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::kFile) throw;
      throw Error(Error::Kind::kFile,
                  fmt::format("{}: {}; has the program changed? Generate into another folder",
                              folder_.string(), error.what()));
    }
  }

  GalleryEntry entry_of(const Solution& solution) const {
    GalleryEntry entry;
    entry.index = solution.number;
    entry.name = fmt::format("{}-{:04}", program_.name(), solution.number);
    entry.json = entry.name + ".json";
    entry.choices = solution.choices.size();
    if (!std::holds_alternative<Nil>(solution.value.is)) entry.value = shortened(solution.text);
    entry.remarks.push_back(quality_text(solution));
    for (const BrokenAssert& broken : solution.broken) entry.remarks.push_back("broken: " + to_text(broken));
    return entry;
  }

  /// Returns the solution's scene, nothing if it places nothing; names its file in the entry.
  std::optional<Scene> scene_of_entry(GalleryEntry& entry, const Solution& solution) {
    if (solution.placements.empty()) return std::nullopt;
    entry.glb = entry.name + ".glb";
    return scene_of(solution, entry.name, assets_);
  }

  /// Puts the solution onto the page.
  void show(GalleryEntry entry, const Solution& solution, const std::optional<Scene>& scene,
            const std::string& glb) {
    const SolutionFiles files =
        page_.add(entry.name, scene ? &*scene : nullptr, glb, json_text(json_of(solution)));
    entry.plan = files.drawing;
    entry.facts = json_text(facts_of(solution, files.script));
    choices_.add(solution.choices);
    entries_.push_back(std::move(entry));
  }

  /// Returns what the page sorts and filters by.
  static Json facts_of(const Solution& solution, const std::string& script) {
    Json facts{{"index", solution.number}, {"script", script}};
    if (Json value = json_of(solution.value); json_text(value).size() <= kComparedValue)
      facts["value"] = std::move(value);
    if (solution.quality) {
      facts["cost"] = solution.quality->cost;
      facts["broken"] = solution.quality->broken;
    }
    return facts;
  }

  GalleryInfo gallery_info() const {
    GalleryInfo info{program_.name(), program_.file_name(), std::to_string(options_.seed),
                     program_.settings(), json_text(run_json(program_, options_))};
    if (written_.solutions > 1) {
      info.options.emplace_back("mean distance of choices", fmt::format("{:.2f}", written_.choice_distance));
      info.options.emplace_back("of results", fmt::format("{:.2f}", written_.result_distance));
    }
    return info;
  }

  std::string json(const std::string& name, const Solution& solution, const Summary& summary) const {
    Json file{{"name", name}, {"index", solution.number}};
    file.update(run_json(program_, options_));
    file.update(json_of(solution));
    if (!solution.auxiliary.empty()) file["auxiliary"] = json_of(solution.auxiliary);
    if (timings_) file["timings"] = timings_json(summary.times);
    return json_text(file, 1) + "\n";
  }

  fs::path folder_;
  Program program_;
  SearchOptions options_;
  bool timings_;
  Nodes nodes_;
  AssetLibrary assets_;
  std::optional<FolderLock> lock_;  // until the folder is closed
  std::optional<PictureFiles> pictures_;
  PageFiles page_;
  std::vector<GalleryEntry> entries_;
  ChoiceColumns choices_;
  Summary written_;  // of the search, as of the last solution whose files are there
};

OutputFolder::OutputFolder(const fs::path& folder, const Program& program, const SearchOptions& options,
                           bool timings, const std::optional<Pictures>& pictures, bool instancing)
    : state_(translated(program.state().program.sources, [&] {
        return std::make_unique<State>(folder, program, options, timings, pictures, instancing);
      })) {}
OutputFolder::~OutputFolder() = default;

void OutputFolder::resume(Search& search) {
  translated(state_->sources(), [&] { state_->resume(search); });
}

std::vector<std::string> OutputFolder::notes() const { return state_->notes(); }

void OutputFolder::add(const Solution& solution, const Summary& summary) {
  translated(state_->sources(), [&] { state_->add(solution, summary); });
}

std::optional<fs::path> OutputFolder::close(std::optional<Ending> ending, StopReason reason) {
  return translated(state_->sources(), [&] { return state_->close(ending, reason); });
}

}  // namespace solitaire::api
