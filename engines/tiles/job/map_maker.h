#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "engines/tiles/chunks/endless_map.h"
#include "engines/tiles/model/mirror.h"
#include "engines/tiles/request/request.h"
#include "engines/tiles/sample/sampler.h"

namespace solitaire::tiles {

/// Makes the maps of a request by their numbers, which may be done by several threads at a time. Whatever is
/// made has been checked by find_faults().
class MapMaker {
 public:
  /// `problem` is that of the request, and `style` its style, to which the weights are added. `chunks` are
  /// the places, in chunks of the map's size, of the regions of an endless map that are wanted instead of
  /// maps of their own. Throws RequestError and FileError.
  MapMaker(const Request& request, std::shared_ptr<Style> style, const Problem& problem,
           const SamplerOptions& options, std::vector<FarPoint> chunks);

  /// Learns weights and whatever else is the same for all maps; before make(). Throws Interrupted.
  void prepare(const StopSignal& stop);
  /// Makes the map of that number, from 1. Throws std::logic_error if it breaks a rule.
  Sample make(std::uint64_t number, const StopSignal& stop) const;

 private:
  Sample make_chunk(const FarPoint& chunk, const StopSignal& stop) const;
  Sample make_with_districts(std::uint64_t number, const StopSignal& stop) const;

  const Request& request_;
  std::shared_ptr<Style> style_;
  const Problem& problem_;
  SamplerOptions options_;
  std::vector<FarPoint> chunks_;
  std::unique_ptr<EndlessMap> endless_;  // where there are chunks
  std::optional<Mirror> mirror_;
  std::vector<TileMask> domains_;  // of the problem, or of its half
  // Where zones are drawn: what makes the coarse maps. Domains then differ from map to map.
  std::optional<Request> coarse_request_;
  std::optional<Problem> coarse_problem_;
  std::vector<std::uint8_t> zone_of_tile_;  // by tile of the coarse map
  std::unique_ptr<MapMaker> coarse_;
};

}  // namespace solitaire::tiles
