#include "library/run_manifest.h"

#include <cmath>
#include <fmt/format.h>

#include "library/freeze.h"
#include "library/program_state.h"
#include "solitaire/value/plain_copy.h"

namespace solitaire::api {
namespace {

const char* name_of(Distinct distinct) {
  if (distinct == Distinct::kChoices) return "choices";
  return distinct == Distinct::kResult ? "result" : "value";
}

const char* level_name(Diversity level) {
  switch (level) {
    case Diversity::kLow:
      return "low";
    case Diversity::kNormal:
      return "normal";
    case Diversity::kHigh:
      break;
  }
  return "high";
}

const char* solver_name(Solver solver) {
  switch (solver) {
    case Solver::kCadical:
      break;
    case Solver::kZ3:
      return "z3";
    case Solver::kThesis:
      return "thesis";
    case Solver::kShred:
      return "shred";
    case Solver::kTiles:
      return "tiles";
  }
  return "cadical";
}

Json pins_json(const std::vector<Pin>& pins, bool forbidden) {
  Json list = Json::array();
  for (const Pin& pin : pins) {
    if (pin.forbidden == forbidden) list.push_back(pin.text());
  }
  return list;
}

void add_pins(Json& json, const Options& options) {
  for (const auto& [member, forbidden] : {std::pair("pin", false), {"forbid", true}}) {
    if (Json pins = pins_json(options.pins, forbidden); !pins.empty()) json[member] = std::move(pins);
  }
  if (!options.pin_file.empty()) json["pin_file"] = options.pin_file.filename().string();
  if (!options.keep.empty()) json["keep"] = options.keep;
}

/// With --all, and --diversity low, a search goes through the solutions in order.
Diversity diversity_of(const SearchOptions& options) {
  return options.diversity.value_or(options.all ? Diversity::kLow : Diversity::kNormal);
}

/// Returns those options that decide which solutions come, apart from how many there are to be.
Json options_json(const SearchOptions& options) {
  Json json{{"distinct", name_of(options.distinct)}, {"diversity", level_name(diversity_of(options))}};
  if (options.min_distance > 0) json["min_distance"] = options.min_distance;
  json["explore"] = options.exploration_name();
  json["max_steps"] = options.max_steps;
  json["max_depth"] = options.max_depth;
  if (options.relax) json["relax"] = true;
  add_pins(json, options);
  return json;
}

Json all_options_json(const SearchOptions& options) {
  Json json = options.all ? Json{{"all", true}} : Json{{"n", options.count}};
  json.update(options_json(options));
  return json;
}

const char* stop_name(StopReason reason) {
  switch (reason) {
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

const char* ending_name(std::optional<Ending> ending, StopReason reason) {
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
  return stop_name(reason);
}

/// Rounds to four digits, which are enough for people and for comparing runs.
double rounded(double distance) { return std::round(distance * 1e4) / 1e4; }

}  // namespace

Json run_json(const Program& program, const SearchOptions& options) {
  Json params = Json::object();
  for (const auto& [param, value] : values_of_params(program.state(), program.settings()))
    params[param] = json_of(frozen(plain(value)));
  const bool uniform = options.sampling == Sampling::kUniform;
  return {{"program", program.file_name()},
          {"params", std::move(params)},
          {"seed", options.seed},
          {"engine", fmt::format("{}/{}", uniform ? "uniform" : "tracing", solver_name(options.solver))},
          {"options", options_json(options)}};
}

Json manifest_json(const SearchOptions& options, const Summary& summary, std::optional<Ending> ending,
                   StopReason reason) {
  Json json{{"options", all_options_json(options)},
            {"solutions", summary.solutions},
            {"ended", ending_name(ending, reason)}};
  if (summary.solutions > 1) {
    json["mean_distance"] = {{"choices", rounded(summary.choice_distance)},
                             {"results", rounded(summary.result_distance)}};
    if (summary.nearest_choices) json["nearest_pair"] = {{"choices", rounded(*summary.nearest_choices)}};
  }
  return json;
}

Json timings_json(const Times& times) {
  return {{"explore", times.explore},
          {"encode", times.encode},
          {"solve", times.solve},
          {"replay", times.replay},
          {"replays", times.replays}};
}

}  // namespace solitaire::api
