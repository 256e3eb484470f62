#include "engines/tiles/job/map_maker.h"

#include <fmt/format.h>
#include <stdexcept>

#include "engines/tiles/check/check.h"
#include "engines/tiles/learn/fit.h"
#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/learn/weights_file.h"
#include "engines/tiles/request/build.h"
#include "engines/tiles/request/read_style.h"
#include "engines/tiles/request/site_rules.h"

namespace solitaire::tiles {
namespace {

/// Adds the soft factors of the samplers that have a use for them; blockss takes those of its paper.
void add_weights(const Request& request, const SamplerOptions& sampling, Style& style,
                 const StopSignal& stop) {
  const SamplerKind kind = sampling.kind;
  if (kind == SamplerKind::kWfc || kind == SamplerKind::kRaster || kind == SamplerKind::kSearch) return;
  const bool fitted = request.weights == WeightsKind::kFitted && !style.exemplars.empty();
  if (request.weights == WeightsKind::kRead) {
    read_weights(request.weights_file, style);
  } else if (fitted && kind != SamplerKind::kBlockSs) {
    fit_weights(style, request.shapes.empty() ? default_shapes(style) : request.shapes, sampling.seed, stop,
                [&](Problem& problem) { add_site_rules_of_any_size(request, problem); });
  } else {
    for (const Size& shape : request.shapes) add_step_shape(style, shape, request.epsilon);
  }
  add_biases(style);
}

/// Says what cannot be had in an endless map, whose chunks know nothing of a border or of a map as a whole.
void require_endless(const Request& request, const SamplerOptions& options) {
  const bool whole = !request.pins.empty() || !request.pin_maps.empty() || !request.borders.empty() ||
                     request.zones || request.districts || !request.connected.empty() ||
                     !request.acyclic.empty() || !request.loops.empty() || !request.counts.empty() ||
                     !request.runs.empty() || !request.distances.empty() || !request.paths.empty() ||
                     !request.keys.empty() || request.mirror || request.size[2] > 1 || request.periodic[0] ||
                     request.periodic[1] || request.periodic[2];
  if (whole) {
    throw RequestError(
        "chunks of an endless map have no pins, borders, zones, rules about the whole map, mirrors, rings or "
        "layers; name the exemplar alone, or a problem file without them");
  }
  if (options.kind != SamplerKind::kWindows) throw RequestError("--chunk goes with the sampler windows only");
}

void require_sound(const Problem& problem, const Grid& map) {
  const std::vector<std::string> faults = find_faults(problem, map, 1);
  if (!faults.empty()) throw std::logic_error("a map breaks the rules: " + faults.front());
}

/// Returns the request for a coarse map, each of whose tiles is a square of the map's sites.
Request coarse_request(const Request& request) {
  Request coarse = *request.districts->coarse;
  const int scale = request.districts->scale;
  for (std::size_t axis = 0; axis < 2; ++axis) coarse.size[axis] = (request.size[axis] + scale - 1) / scale;
  coarse.size[2] = 1;
  return coarse;
}

}  // namespace

MapMaker::MapMaker(const Request& request, std::shared_ptr<Style> style, const Problem& problem,
                   const SamplerOptions& options, std::vector<FarPoint> chunks)
    : request_(request),
      style_(std::move(style)),
      problem_(problem),
      options_(options),
      chunks_(std::move(chunks)) {
  if (!chunks_.empty()) require_endless(request, options);
  if (!request.districts) return;
  if (request.mirror) throw RequestError("a mirrored map cannot have zones that are drawn");
  coarse_request_ = coarse_request(request);
  const std::shared_ptr<Style> coarse_style = read_style(*coarse_request_);
  coarse_problem_ = make_problem(*coarse_request_, coarse_style);
  coarse_ = std::make_unique<MapMaker>(*coarse_request_, coarse_style, *coarse_problem_, options,
                                       std::vector<FarPoint>());
  zone_of_tile_ = zones_by_tile(request, coarse_style->tileset);
}

void MapMaker::prepare(const StopSignal& stop) {
  // Where rules about single sites leave no map, nobody waits for weights.
  const bool has_own_domains = chunks_.empty() && !coarse_ && !request_.mirror;
  if (has_own_domains) domains_ = consistent_domains(problem_);
  if (has_own_domains && domains_.empty()) return;
  add_weights(request_, options_, *style_, stop);
  if (!chunks_.empty()) {
    endless_ = std::make_unique<EndlessMap>(style_, options_.seed);
    const Outcome outcome = endless_->prepare(stop);
    if (outcome == Outcome::kStopped) throw Interrupted();
    if (outcome != Outcome::kFound) {
      throw RequestError(
          "no small periodic map was found to begin an endless map with; let the exemplar be periodic, or "
          "make maps of a size");
    }
    return;
  }
  if (coarse_) return coarse_->prepare(stop);
  mirror_ = make_mirror(request_, problem_);
  if (mirror_) domains_ = consistent_domains(mirror_->half());
}

Sample MapMaker::make(std::uint64_t number, const StopSignal& stop) const {
  if (endless_) return make_chunk(chunks_[number - 1], stop);
  if (coarse_) return make_with_districts(number, stop);
  Sample sample = draw_sample(mirror_ ? mirror_->half() : problem_, domains_, options_, number, stop);
  if (sample.outcome != Outcome::kFound) return sample;
  if (mirror_) sample.map = mirror_->unfold(sample.map);
  require_sound(problem_, sample.map);
  return sample;
}

Sample MapMaker::make_chunk(const FarPoint& chunk, const StopSignal& stop) const {
  Sample sample;
  const Size& size = problem_.size();
  try {
    sample.map = endless_->region({chunk[0] * size.width(), chunk[1] * size.height()}, size, stop);
  } catch (const std::length_error& error) {
    throw RequestError(error.what());
  }
  sample.outcome = Outcome::kFound;
  require_sound(problem_, sample.map);
  return sample;
}

Sample MapMaker::make_with_districts(std::uint64_t number, const StopSignal& stop) const {
  const Sample coarse = coarse_->make(number, stop);
  if (coarse.outcome != Outcome::kFound) return coarse;
  std::vector<std::uint8_t> zones;
  for_each_point(problem_.size(), [&](const Point& at) {
    const int scale = request_.districts->scale;
    zones.push_back(zone_of_tile_[coarse.map.at({at[0] / scale, at[1] / scale, 0})]);
  });
  Problem problem = problem_;
  problem.set_zones(std::move(zones));
  Sample sample = draw_sample(problem, consistent_domains(problem), options_, number, stop);
  if (sample.outcome == Outcome::kFound) require_sound(problem, sample.map);
  return sample;
}

}  // namespace solitaire::tiles
