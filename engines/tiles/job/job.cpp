#include "engines/tiles/job/job.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <fmt/format.h>
#include <future>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/counted.h"
#include "engines/tiles/check/check.h"
#include "engines/tiles/count/count.h"
#include "engines/tiles/explain/explain.h"
#include "engines/tiles/job/box_text.h"
#include "engines/tiles/job/map_maker.h"
#include "engines/tiles/learn/divergence.h"
#include "engines/tiles/learn/weights_file.h"
#include "engines/tiles/read/exemplar.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/read/png.h"
#include "engines/tiles/request/build.h"
#include "engines/tiles/request/read_inputs.h"
#include "engines/tiles/request/read_style.h"
#include "engines/tiles/request/site_rules.h"
#include "engines/tiles/tiled/tileset_files.h"
#include "engines/tiles/tiled/write_tiled.h"
#include "engines/tiles/write/json.h"
#include "engines/tiles/write/png.h"
#include "engines/tiles/write/text.h"
#include "engines/tiles/write/vox.h"

namespace solitaire::tiles {
namespace {

/// How long it takes at most until a wish to stop is passed on.
constexpr std::chrono::milliseconds kPatience(10);

/// The shapes of patches whose frequencies are compared with those of the exemplars.
const std::array<Size, 6> kSummedUp{
    {{{1, 1, 1}}, {{2, 1, 1}}, {{1, 2, 1}}, {{2, 2, 1}}, {{4, 1, 1}}, {{1, 4, 1}}}};

/// Stops whatever still looks at a signal when a run is left, in whichever way.
struct StopAtEnd {
  StopSignal& signal;
  ~StopAtEnd() { signal.request(); }
};

/// Returns the request of the problem file and the options together.
Request full_request(const JobOptions& options) {
  Request request = read_inputs(options.inputs, options.debroglie);
  request.size = {options.width.value_or(request.size[0]), options.height.value_or(request.size[1]),
                  options.depth.value_or(request.size[2])};
  request.periodic[0] = request.periodic[0] || options.periodic_x;
  request.periodic[1] = request.periodic[1] || options.periodic_y;
  if (options.tile_side) request.tile_side = options.tile_side;
  request.symmetry = options.symmetry.value_or(request.symmetry);
  request.weights = options.weights.value_or(request.weights);
  for (const std::string& pin : options.pins) {
    request.pins.push_back(parse_pin(pin));
    request.pins.back().where = "--pin " + pin;
  }
  for (const auto& map : options.pin_maps) request.pin_maps.push_back(map);
  for (const std::string& names : options.connected)
    request.connected.push_back({split(names, ','), {}, {}, "--connected " + names});
  return request;
}

/// Returns whether each site of a map is to be made anew.
std::vector<bool> redone_sites(const std::string& redo, const Size& size) {
  std::vector<bool> redone;
  redone.reserve(size.volume());
  if (redo.ends_with(".png")) {
    const Picture mask = read_png(redo, read_bytes(redo));
    for_each_point(size, [&](const Point& at) {
      const Rgba& color = mask.at_share(at[0], size.width(), at[1], size.height());
      redone.push_back(color[3] >= 128 && std::max({color[0], color[1], color[2]}) >= 128);
    });
    return redone;
  }
  const PinEntry box = counted_in(size, parse_box(redo));
  for_each_point(size, [&](const Point& at) {
    redone.push_back(at[0] >= box.from[0] && at[0] < box.to[0] && at[1] >= box.from[1] && at[1] < box.to[1]);
  });
  return redone;
}

/// Pins all sites of a map but those that are made anew.
void keep_rest(const JobOptions& options, int tile_side, Problem& problem) {
  if (options.from.empty() != options.redo.empty()) throw RequestError("--from and --redo go together");
  if (options.from.empty()) return;
  Tileset tileset = problem.style().tileset;
  const Grid map = read_exemplar(options.from, tile_side, tileset, false);
  if (!(map.size == problem.size())) {
    throw RequestError(
        fmt::format("{} has another size than the maps; say its size with -W and -H", options.from.string()));
  }
  const std::vector<bool> redone = redone_sites(options.redo, map.size);
  const std::string text = fmt::format("it is kept from {}", options.from.string());
  for (std::uint32_t site = 0; site < map.tiles.size(); ++site) {
    if (!redone[site] && map[site] != kHole) problem.add({text, {site}, TileMask::of(map[site])});
  }
}

std::vector<FarPoint> chunks_of(const JobOptions& options, const Size& size) {
  std::vector<FarPoint> chunks;
  for (const std::string& text : options.chunks) {
    const FarPoint chunk = parse_far_point(text);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const std::int64_t most = kFarthest / size.extent.at(axis);
      if (chunk.at(axis) < -most || chunk.at(axis) > most)
        throw RequestError(fmt::format("the chunk {} is too far from the origin", text));
    }
    chunks.push_back(chunk);
  }
  return chunks;
}

/// Returns the share that each tile has of a map.
nlohmann::ordered_json shares_of(const Grid& map, const Tileset& tileset) {
  std::vector<std::size_t> counts(tileset.size());
  for (const Tile tile : map.tiles) {
    if (tile != kHole) ++counts[tile];
  }
  nlohmann::ordered_json shares = nlohmann::ordered_json::object();
  for (std::size_t tile = 0; tile < counts.size(); ++tile) {
    shares[tileset[static_cast<Tile>(tile)].name] =
        static_cast<double>(counts[tile]) / static_cast<double>(map.tiles.size());
  }
  return shares;
}

/// Returns how far the patches of a map are from those of the exemplars, by shape: the divergences of
/// Kullback and Leibler and of Jensen and Shannon.
nlohmann::ordered_json divergences_of(const Style& style, const Grid& map) {
  nlohmann::ordered_json divergences = nlohmann::ordered_json::object();
  for (const Size& shape : kSummedUp) {
    const Divergence d = divergence(style, {&map, 1}, shape);
    divergences[size_text(shape)] = {{"kl", d.kullback_leibler}, {"js", d.jensen_shannon}};
  }
  return divergences;
}

}  // namespace

struct Job::State {
  State(const JobOptions& given, std::function<bool()> asked_to_stop)
      : options(given),
        stopped(std::move(asked_to_stop)),
        request(full_request(given)),
        style(read_style(request)),
        problem(make_problem(request, style)),
        maker(request, style, problem, options.sampling, chunks_of(options, problem.size())) {
    keep_rest(options, request.side_of_tiles(), problem);
    if (!options.chunks.empty()) options.maps = options.chunks.size();
  }

  void prepare();
  JobEnding make_maps(const std::function<void(std::uint64_t)>& deliver);
  void require_one_problem() const;
  void keep(Sample&& made);

  /// Waits for work on another thread, and passes a wish to stop on to it.
  template <class Result>
  Result outcome(std::future<Result>& running) {
    while (running.wait_for(kPatience) != std::future_status::ready) {
      if (stopped()) stop.request();
    }
    return running.get();
  }
  /// Does work on another thread, so that a wish to stop reaches it.
  template <class Work>
  auto attended(const Work& work) {
    auto running = std::async(std::launch::async, work);
    return outcome(running);
  }

  JobOptions options;
  std::function<bool()> stopped;
  Request request;
  std::shared_ptr<Style> style;
  Problem problem;
  MapMaker maker;
  bool is_prepared = false;
  StopSignal stop;
  std::uint64_t number = 0;
  Sample sample;  // that of the number
  std::vector<Grid> maps;
  std::uint64_t windows = 0, left = 0, refused = 0;
};

void Job::State::prepare() {
  if (is_prepared) return;
  attended([this] { maker.prepare(stop); });
  is_prepared = true;
}

JobEnding Job::State::make_maps(const std::function<void(std::uint64_t)>& deliver) {
  prepare();
  StopSignal signal(&stop);
  std::deque<std::future<Sample>> running;
  const StopAtEnd stop_at_end{signal};
  std::uint64_t begun = 0;
  for (number = 1; number <= options.maps; ++number) {
    // Maps that are made faster than the wait for them looks up would not be stopped otherwise.
    if (stopped()) return JobEnding::kStopped;
    while (begun < options.maps && running.size() < options.jobs) {
      running.push_back(
          std::async(std::launch::async, [&, next = ++begun] { return maker.make(next, signal); }));
    }
    sample = outcome(running.front());
    running.pop_front();
    if (sample.outcome == Outcome::kStopped) return JobEnding::kStopped;
    if (sample.outcome == Outcome::kNone) return JobEnding::kNoMap;
    if (sample.outcome == Outcome::kGaveUp) return JobEnding::kGaveUp;
    deliver(number);
    keep(std::move(sample));
  }
  return JobEnding::kDone;
}

/// Remembers a map that was delivered, for the summary.
void Job::State::keep(Sample&& made) {
  maps.push_back(std::move(made.map));
  windows += made.windows;
  left += made.left;
  refused += made.refused;
}

/// For questions about all maps, which have no answer where the zones of each are drawn anew.
void Job::State::require_one_problem() const {
  if (request.districts)
    throw RequestError("the zones of each map are drawn anew, so that nothing holds of all maps");
}

Job::Job(const JobOptions& options, std::function<bool()> stopped)
    : state_(std::make_unique<State>(options, std::move(stopped))) {}
Job::~Job() = default;

std::vector<std::string> Job::check(const std::filesystem::path& file) const {
  state_->require_one_problem();
  Tileset tileset = state_->style->tileset;
  return find_faults(state_->problem, read_exemplar(file, state_->request.side_of_tiles(), tileset, false));
}

std::optional<std::string> Job::count() const {
  state_->require_one_problem();
  return state_->attended([this] { return count_maps(state_->problem, state_->stop); });
}

std::optional<std::vector<std::string>> Job::explain() const {
  state_->require_one_problem();
  const auto reason = state_->attended([this] { return explain_no_map(state_->problem, state_->stop); });
  if (!reason) return std::nullopt;
  return reason->rules;
}

std::vector<std::string> Job::notes() const {
  std::vector<std::string> notes = state_->request.notes;
  if (state_->request.tile_side || state_->options.debroglie) return notes;
  for (const Exemplar& exemplar : state_->style->exemplars) {
    if (!exemplar.name.ends_with(".png")) continue;
    notes.push_back(
        fmt::format("{}: each of its pixels is a tile, which makes {} tiles of {} kinds; if tiles are "
                    "squares of N pixels, say --tile N",
                    exemplar.name, size_text(exemplar.grid.size), state_->style->tileset.size()));
    break;
  }
  return notes;
}

std::vector<std::string> Job::warnings() const { return tiles_that_need_a_border(state_->problem); }

std::string Job::weights() {
  state_->prepare();
  return write_weights(*state_->style);
}

JobEnding Job::run(const std::function<void(std::uint64_t)>& deliver) {
  try {
    return state_->make_maps(deliver);
  } catch (const Interrupted&) {
    return JobEnding::kStopped;
  }
}

void Job::require_format(const std::string& format) const {
  if (format != "tmx" && format != "tmj") return;
  const auto& exemplars = state_->request.exemplars;
  const bool is_pattern = !exemplars.empty() && (is_tileset(exemplars.front().file) ||
                                                 exemplars.front().file.extension() == "." + format);
  if (!is_pattern)
    throw RequestError(fmt::format(
        "--format {0} needs a .{0} map or a tileset of Tiled (.tsx, .tsj) as the first exemplar", format));
}

std::string Job::file(const std::string& format, int pixels, const std::filesystem::path& folder) const {
  const Sample& sample = state_->sample;
  const Tileset& tileset = state_->style->tileset;
  if (format == "txt") return write_text(sample.map, tileset);
  if (format == "png") return write_png(sample.map, tileset, pixels);
  if (format == "vox") {
    try {
      return write_vox(sample.map, tileset);
    } catch (const std::length_error& error) {
      throw RequestError(error.what());
    }
  }
  if (format == "tmx" || format == "tmj") {
    require_format(format);
    const std::filesystem::path& pattern = state_->request.exemplars.front().file;
    return (format == "tmx" ? write_tmx : write_tmj)(sample.map, tileset, pattern, folder);
  }
  nlohmann::ordered_json about{{"index", state_->number},
                               {"seed", state_->options.sampling.seed},
                               {"sampler", name_of(state_->options.sampling.kind)},
                               {"sweeps", sample.sweeps},
                               {"windows", sample.windows},
                               {"refused", sample.refused},
                               {"shares", shares_of(sample.map, tileset)}};
  if (!state_->style->exemplars.empty()) about["divergence"] = divergences_of(*state_->style, sample.map);
  return write_json(sample.map, tileset, about);
}

namespace {

std::array<double, 3> shown_color(const Rgba& color) {
  std::array<double, 3> shown{};
  for (std::size_t channel = 0; channel < 3; ++channel) shown.at(channel) = color.at(channel) / 255.0;
  return shown;
}

std::shared_ptr<const ShownModel> shown_model(const VoxelModel& voxels) {
  ShownModel model{voxels.size.width(), voxels.size.depth(), {}};
  for_each_point(voxels.size, [&](const Point& at) {
    if (voxels.at(at) == 0) return;
    model.voxels.push_back(
        {{at[0], voxels.size.height() - 1 - at[1], at[2]}, shown_color(voxels.color(voxels.at(at)))});
  });
  return std::make_shared<const ShownModel>(std::move(model));
}

/// Returns the models by tile; nothing for a tile without one.
std::vector<std::shared_ptr<const ShownModel>> shown_models(const Tileset& tileset) {
  std::vector<std::shared_ptr<const ShownModel>> models(tileset.size());
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const auto& voxels = tileset[static_cast<Tile>(tile)].voxels;
    if (voxels) models[tile] = shown_model(*voxels);
  }
  return models;
}

}  // namespace

std::vector<ShownTile> Job::shown_tiles() const {
  const auto models = shown_models(state_->style->tileset);
  const Grid& map = state_->sample.map;
  std::vector<ShownTile> shown;
  for_each_point(map.size, [&](const Point& at) {
    if (map.at(at) == kHole) return;
    const TileKind& kind = state_->style->tileset[map.at(at)];
    const auto& model = models[map.at(at)];
    if (kind.height == 0 || kind.color[3] == 0 || (model && model->voxels.empty())) return;
    ShownTile tile{kind.name, at, kind.asset, kind.turn, kind.height, shown_color(kind.color), model};
    tile.at[1] = map.size.height() - 1 - at[1];
    shown.push_back(std::move(tile));
  });
  return shown;
}

std::string Job::summary() const {
  const State& state = *state_;
  std::string text = fmt::format("{} of {}, {} redrawn", counted(state.maps.size(), "map"),
                                 size_text(state.problem.size()), counted(state.windows, "window"));
  if (state.left > 0) text += fmt::format(", {} left as they were", state.left);
  if (state.refused > 0) text += fmt::format(", {} put back", state.refused);
  if (state.style->exemplars.empty()) return text + "\n";
  text += "\n  divergence from the exemplars (KL/JS):";
  for (const Size& shape : kSummedUp) {
    const Divergence d = divergence(*state.style, state.maps, shape);
    text += fmt::format(" {} {:.2f}/{:.2f}", size_text(shape), d.kullback_leibler, d.jensen_shannon);
  }
  return text + "\n";
}

}  // namespace solitaire::tiles
