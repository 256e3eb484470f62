#include "engines/tile_maps/tile_stream.h"

#include <algorithm>
#include <unordered_set>

#include "base/hash.h"
#include "engines/errors.h"
#include "engines/tile_maps/map_style.h"
#include "engines/tile_maps/program_map.h"
#include "engines/tiles/sample/sampler.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

TracingOptions running_each(TracingOptions options) {
  options.replay = Replay::kEvery;  // maps show when a program is run
  return options;
}

tiles::Grid grid_of(const TileMap& map, const Execution& start) {
  tiles::Grid grid(tiles::Size{{static_cast<int>(map.width), static_cast<int>(map.height), 1}});
  for (std::size_t site = 0; site < grid.tiles.size(); ++site)
    grid[site] = static_cast<tiles::Tile>(start.choices[map.first_choice + site].value.as_int());
  return grid;
}

}  // namespace

TileStream::TileStream(const Program& program, ParamValues params, const TracingOptions& options)
    : program_(program), options_(running_each(options)), traced_(program, std::move(params), options_) {}

std::optional<Solution> TileStream::next() {
  if (ending_ != Ending::kNone) return std::nullopt;
  try {
    traced_.explore();
    traced_.solver().suggest_random_values(number_);
    ending_ = ending_of(find());
    if (ending_ != Ending::kNone) return std::nullopt;
    Solution solution = sampled();
    ++number_;
    return solution;
  } catch (const Interrupted&) {
    ending_ = Ending::kStopped;
    return std::nullopt;
  }
}

ExecutionSolver::Outcome TileStream::find() {
  ExecutionSolver& solver = traced_.solver();
  while (true) {
    traced_.meet_pass();
    if (traced_.trace().has_costs())
      throw UnequalSolutions("--engine tiles draws maps by how their exemplars look, and knows no wishes");
    const std::size_t pass = solver.passes();
    const ExecutionSolver::Outcome outcome = solver.find([] { return std::vector<NodeId>(); });
    if (pass == solver.passes()) return outcome;
  }
}

Solution TileStream::sampled() {
  Assignment assignment = traced_.solver().assignment();
  variables_ = variables_of(assignment);
  const Execution start = traced_.execution(assignment);
  if (start.tile_maps.empty())
    throw NoTileMap(
        "--engine tiles draws the maps of 'tile_map' (std/tiles.sol), and the program makes none");
  LiveConditions conditions(traced_.graph(), conditions_beside_pairs(), assignment);
  if (conditions.broken() > 0) throw InternalError("a solution breaks a condition of its trace");
  Valuation values;
  for (const MetChoice& choice : start.choices) values.emplace(choice.address, choice.value);
  redraw_maps(start, conditions, values);
  Execution execution = traced_.execution(values);
  if (execution.rejection) throw InternalError("a map that was drawn is none of the program");
  return traced_.solution(std::move(execution));
}

/// Returns all that holds in solutions but what `tile_map` says of neighbours, which windows keep by
/// themselves.
std::vector<NodeId> TileStream::conditions_beside_pairs() {
  const Graph& graph = traced_.graph();
  const std::vector<NodeId> pairs = conjuncts(graph, traced_.pass().tile_neighbors);
  const std::unordered_set<NodeId> kept(pairs.begin(), pairs.end());
  std::vector<NodeId> conditions = conjuncts(graph, traced_.requirements(true));
  std::erase_if(conditions, [&](NodeId each) { return kept.contains(each); });
  return conditions;
}

std::map<AddressId, NodeId> TileStream::variables_of(Assignment& assignment) const {
  std::map<AddressId, NodeId> variables;
  for (const TraceChoice& choice : traced_.trace().choices) {
    if (assignment.holds(choice.guard)) variables.emplace(choice.address, choice.variable);
  }
  return variables;
}

void TileStream::redraw_maps(const Execution& start, LiveConditions& conditions, Valuation& values) {
  const DerivedChoices derived(traced_.graph(), traced_.trace(), conditions);
  std::uint64_t number = 0;
  for (const TileMap& map : start.tile_maps) redraw(map, number++, start, conditions, derived, values);
  for (const MetChoice& choice : start.choices) {
    const auto variable = variables_.find(choice.address);
    if (!choice.auxiliary || variable == variables_.end() || !conditions.depends_on(variable->second))
      continue;
    if (const auto value = conditions.value(variable->second))
      values[choice.address] = TypedScalar(choice.value.type(), *value);
  }
}

void TileStream::redraw(const TileMap& map, std::uint64_t number, const Execution& start,
                        LiveConditions& conditions, const DerivedChoices& derived, Valuation& values) {
  const tiles::Grid shown = grid_of(map, start);
  std::vector<NodeId> variables;
  for (std::size_t site = 0; site < shown.tiles.size(); ++site) {
    const auto found = variables_.find(start.choices[map.first_choice + site].address);
    variables.push_back(found == variables_.end() ? kTrue : found->second);  // what is pinned is no variable
  }
  tiles::Problem problem(style_of(map.source), {shown.size, {}});
  add_conditions_on_sites(traced_.graph(), conditions, variables, shown, problem);
  const bool asks = std::ranges::any_of(variables, [&](NodeId each) { return conditions.depends_on(each); });
  if (asks) problem.add(std::make_shared<ProgramRule>(conditions, derived, variables, shown));
  tiles::SamplerOptions sampling;
  sampling.seed = mix(options_.seed, number_);
  const tiles::Sample sample =
      tiles::redraw_map(problem, tiles::consistent_domains(problem), sampling, number, traced_.stop(), shown);
  if (sample.outcome != tiles::Outcome::kFound) throw Interrupted();
  problem.violation(sample.map);  // the conditions are to know the last map
  for (std::size_t site = 0; site < shown.tiles.size(); ++site) {
    const MetChoice& choice = start.choices[map.first_choice + site];
    values[choice.address] =
        TypedScalar(choice.value.type(), Scalar::of(static_cast<std::int64_t>(sample.map[site])));
  }
}

std::shared_ptr<const tiles::Style> TileStream::style_of(const Value& source) {
  std::shared_ptr<const tiles::Style>& style = styles_[to_text(source)];
  if (style == nullptr) style = style_of_source(source, program_, options_.seed, traced_.stop());
  return style;
}

}  // namespace solitaire
