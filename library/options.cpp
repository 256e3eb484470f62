#include <charconv>
#include <fmt/format.h>
#include <solitaire/error.h>
#include <solitaire/options.h>

#include "engines/thesis/published_method.h"
#include "library/engine_options.h"
#include "library/pins.h"
#include "library/stop_access.h"

namespace solitaire::api {
namespace {

std::optional<std::uint64_t> random_executions(const std::string& text) {
  constexpr std::string_view kPrefix = "random:";
  if (text.compare(0, kPrefix.size(), kPrefix) != 0) return std::nullopt;
  std::uint64_t count = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + kPrefix.size(), end, count);
  if (error != std::errc{} || stop != end || count == 0) return std::nullopt;
  return count;
}

Exploration exploration_of(const Options& options) {
  const std::string name = options.exploration_name();
  if (const std::string wrong = check_exploration(name); !wrong.empty())
    throw Error(Error::Kind::kUsage, wrong);
  const auto executions = random_executions(name);
  if (executions) return {Exploration::Policy::kRandom, *executions};
  if (options.solver == Solver::kThesis)
    throw Error(Error::Kind::kUsage, "the thesis engine explores at random only: random:N");
  return {};
}

const SearchMethod& method_of(Solver solver) {
  switch (solver) {
    case Solver::kCadical:
    case Solver::kShred:
    case Solver::kTiles:
      break;
    case Solver::kZ3:
      return z3_method();
    case Solver::kThesis:
      return published_method();
  }
  return cadical_method();
}

solitaire::SceneDetail detail_of(SceneDetail detail) {
  switch (detail) {
    case SceneDetail::kNone:
      return solitaire::SceneDetail::kNone;
    case SceneDetail::kPlacements:
      return solitaire::SceneDetail::kPlacements;
    case SceneDetail::kProvenance:
      break;
  }
  return solitaire::SceneDetail::kProvenance;
}

}  // namespace

std::string check_exploration(const std::string& text) {
  if (text == "demand" || random_executions(text)) return "";
  return fmt::format(
      "'{}' is no way to explore: there are demand and random:N, N a number of executions from 1", text);
}

std::string Options::exploration_name() const {
  if (!explore.empty()) return explore;
  return solver == Solver::kThesis ? "random:100" : "demand";
}

TracingOptions engine_options(const Program& program, const Options& options) {
  TracingOptions tracing;
  tracing.exploration = exploration_of(options);
  tracing.seed = options.seed;
  tracing.method = &method_of(options.solver);
  tracing.diverse = tracing.method->can_diversify();
  tracing.pins = pins_of(program, options);
  tracing.limits.max_steps = options.max_steps;
  tracing.limits.max_depth = options.max_depth;
  tracing.limits.stop = StopAccess::signal(options.stop);
  return tracing;
}

TracingOptions engine_options(const Program& program, const SearchOptions& options) {
  TracingOptions tracing = engine_options(program, static_cast<const Options&>(options));
  const Diversity usual = options.all ? Diversity::kLow : Diversity::kNormal;
  const Diversity diversity = options.diversity.value_or(usual);
  tracing.diverse = tracing.diverse && diversity != Diversity::kLow;
  tracing.far_apart = diversity == Diversity::kHigh;
  tracing.replay = options.run_each ? Replay::kEvery : Replay::kSome;
  tracing.relax = options.relax;
  tracing.improvement_time = options.seconds_per_solution;
  tracing.min_distance = DistanceBound::of(options.min_distance);
  tracing.scene = detail_of(options.scene);
  return tracing;
}

}  // namespace solitaire::api
