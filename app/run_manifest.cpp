#include "app/run_manifest.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/signals.h"

namespace solitaire {
namespace {

const char* level_name(DiversityLevel level) {
  switch (level) {
    case DiversityLevel::kLow:
      return "low";
    case DiversityLevel::kNormal:
      return "normal";
    case DiversityLevel::kHigh:
      break;
  }
  return "high";
}

using Json = nlohmann::ordered_json;

/// Those that decide which solutions come.
Json options_json(const Options& options) {
  Json json = Json::object();
  if (options.all) {
    json["all"] = true;
  } else {
    json["n"] = options.count;
  }
  json["distinct"] = options.distinct == Distinct::kResult ? "result" : "choices";
  if (options.diversity) json["diversity"] = level_name(*options.diversity);
  if (options.min_distance > 0) json["min_distance"] = options.min_distance;
  json["explore"] = options.exploration_name();
  json["max_steps"] = options.max_steps;
  json["max_depth"] = options.max_depth;
  if (options.relax) json["relax"] = true;
  if (!options.pins.empty()) json["pin"] = options.pins;
  if (!options.forbidden.empty()) json["forbid"] = options.forbidden;
  if (!options.pin_file.empty()) json["pin_file"] = options.pin_file.filename().string();
  if (!options.keep.empty()) json["keep"] = options.keep;
  return json;
}

const char* stop_name() {
  switch (stop_signal().reason()) {
    case StopReason::kNone:
    case StopReason::kInterrupt:
      return "interrupt";
    case StopReason::kTime:
      return "timeout";
    case StopReason::kTimePerSolution:
      return "per_solution";
    case StopReason::kMemory:
    case StopReason::kOutOfMemory:
      return "memory";
  }
  return "";
}

const char* ending_name(std::optional<Ending> ending) {
  if (!ending) return "error";
  switch (*ending) {
    case Ending::kNone:
      return "enough";
    case Ending::kExhausted:
      return "exhausted";
    case Ending::kUnexplored:
      return "unexplored";
    case Ending::kWrapped:
      return "wrapped";
    case Ending::kStopped:
      break;
  }
  return stop_name();
}

/// Four digits are enough for people and for comparing runs.
double rounded(double distance) { return std::round(distance * 1e4) / 1e4; }

}  // namespace

Json run_manifest(const Options& options, const Diversity& diversity, std::optional<Ending> ending) {
  Json json{{"options", options_json(options)},
            {"solutions", diversity.solutions()},
            {"ended", ending_name(ending)}};
  if (diversity.solutions() > 1) {
    json["mean_distance"] = {{"choices", rounded(diversity.of_choices())},
                             {"results", rounded(diversity.of_results())}};
  }
  return json;
}

}  // namespace solitaire
