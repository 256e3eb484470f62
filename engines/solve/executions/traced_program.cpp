#include "engines/solve/executions/traced_program.h"

#include <set>
#include <tuple>
#include <utility>

#include "engines/freeze.h"
#include "engines/solve/executions/pin_check.h"
#include "engines/solve/executions/requirements.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

/// Returns true for what must hold in every execution: asserts may be broken if `relax` says so.
ExecutionSolver::Firm firmness(bool relax) {
  return [relax](const Term& term) { return !relax || term.requirement != ConstraintKind::kAssert; };
}

TracingOptions for_solver(TracingOptions options, const StopSignal& stop) {
  options.limits.stop = &stop;
  options.limits.keep_going = options.limits.open_comparisons = options.relax;
  return options;
}

/// Counts an assert once, however many of its conjuncts are broken.
std::size_t count_broken(const Solution& solution) {
  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t>> broken;
  for (const BrokenAssert& each : solution.broken)
    broken.emplace(each.address, each.whole.source, each.whole.begin);
  return broken.size();
}

}  // namespace

TracedProgram::TracedProgram(const Program& program, ParamValues params, const TracingOptions& options,
                             std::uint64_t first)
    : program_(program),
      params_(std::move(params)),
      options_(options),
      stop_(options.limits.stop),
      pins_(options.pins, addresses_),
      choices_(pins_),
      solver_(program_, params_, for_solver(options, stop_), choices_, graph_, addresses_,
              firmness(options.relax), first),
      replayer_(program_, params_, options_, solver_, first),
      errors_(solver_, replayer_),
      provenance_(program_, params_, options_, pins_, solver_) {}

void TracedProgram::meet_pass() {
  while (met_pass_ != solver_.passes()) {
    if (met_pass_ == 0) check_pins(pins_, solver_, program_, params_, for_solver(options_, stop_));
    met_pass_ = solver_.passes();
    for (const PinnedChoice& pinned : pinned_choices(graph_, pass(), pins_)) solver_.require(pinned.holds);
    for (const NodeId condition : options_.method->conditions(graph_, trace())) solver_.require(condition);
    if (!options_.relax) errors_.report_reachable();  // it may run a further pass
  }
}

bool TracedProgram::explore_fully() {
  explore();
  meet_pass();  // an error that is known by now ends the search before it goes far
  const bool complete = solver_.explore_fully(tuning::kMostPasses);
  meet_pass();
  return complete;
}

bool TracedProgram::check() {
  try {
    explore();
    meet_pass();
  } catch (const Interrupted&) {
    return false;
  }
  return !stop_.stopped();
}

std::vector<NodeId> TracedProgram::requirements(bool closed) {
  const auto firm = firmness(options_.relax);
  std::vector<NodeId> conditions =
      closed ? requirements_of(graph_, trace(), firm) : requirements_of_any_path(graph_, trace(), firm);
  for (const PinnedChoice& pinned : pinned_choices(graph_, pass(), pins_)) conditions.push_back(pinned.holds);
  return conditions;
}

Execution TracedProgram::execution(const ChosenValues& choices) {
  explore();
  return replayer_.execution(choices);
}

Solution TracedProgram::solution(Execution execution) {
  const std::size_t wishes = execution.wishes.size();
  const std::int64_t cost = execution.cost;
  Solution solution = solution_of(std::move(execution), addresses_);
  if (options_.relax || trace().has_costs())
    solution.quality = Quality{count_broken(solution), wishes, cost, false, {}};
  if (options_.scene == SceneDetail::kProvenance) {
    provenance_.add_object_choices(solution);
    provenance_.add_wish_choices(solution);
  }
  provenance_.add_broken_choices(solution);
  return solution;
}

}  // namespace solitaire
