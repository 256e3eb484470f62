#include "engines/solve/tracing.h"

#include <algorithm>
#include <utility>

#include "engines/errors.h"
#include "engines/seen.h"
#include "engines/solve/executions/auxiliary.h"
#include "engines/tuning.h"
#include "smt/tuning.h"

namespace solitaire {
namespace {

Valuation values_of(const Execution& execution) {
  Valuation values;
  for (const MetChoice& choice : execution.choices) values.emplace(choice.address, choice.value);
  return values;
}

}  // namespace

TracingEngine::TracingEngine(const Program& program, ParamValues params, const TracingOptions& options,
                             std::uint64_t first)
    : options_(options),
      traced_(program, std::move(params), options, first),
      exclusion_(traced_.solver(), options),
      distances_(traced_.solver(), options.min_distance),
      best_first_(traced_.solver(), options, traced_.stop()),
      may_enumerate_(!options.diverse && !options.relax && options.method->may_enumerate() &&
                     !options.min_distance.any()),
      number_(first) {}

std::optional<Solution> TracingEngine::next() {
  if (ending_ != Ending::kNone) return std::nullopt;
  const auto start = StopSignal::Clock::now();
  try {
    explore();
    meet_pass();  // errors are asked for before values are suggested
    if (may_enumerate_) {
      std::optional<Solution> solution = next_enumerated();
      if (solution || ending_ != Ending::kNone) return solution;
    }
  } catch (const Interrupted&) {
    ending_ = Ending::kStopped;
    return std::nullopt;
  }
  return next_searched(start);
}

/// Returns the best solution that the solver finds, or nothing and sets the ending.
std::optional<Solution> TracingEngine::next_searched(StopSignal::Clock::time_point start) {
  if (options_.diverse) traced_.solver().suggest_random_values(number_++);
  Attempt best =
      best_first_.next([this](const BestFirst::Most& most) { return attempt(most); }, told_, start);
  ending_ = best.ending;
  if (options_.relax && leaves_out_executions()) {
    if (ending_ == Ending::kExhausted) ending_ = Ending::kUnexplored;
    if (best.found && best.found->solution.quality) best.found->solution.quality->proved = false;
  }
  if (!best.found) return std::nullopt;
  remember(std::move(best.found->values));
  return std::move(best.found->solution);
}

/// Returns true if some near misses cannot be found, so that none is proved to be the best or the last.
bool TracingEngine::leaves_out_executions() {
  const std::size_t pass = traced_.solver().passes();
  if (std::exchange(asked_pass_, pass) != pass) leaves_out_ = traced_.leaves_out_executions();
  return leaves_out_;
}

/// Looks for a new solution within these bounds: asks the solver until it has one that did not come before
/// and is far enough from those that did.
Attempt TracingEngine::attempt(const BestFirst::Most& most) {
  ExecutionSolver& solver = traced_.solver();
  while (true) {
    const ExecutionSolver::Outcome outcome = find(most);
    if (outcome != ExecutionSolver::Outcome::kFound) return {{}, ending_of(outcome)};
    Assignment assignment = solver.assignment();
    const TracedChoices met = solver.met(assignment);
    if (exclusion_.repeats(met.values)) continue;
    try {
      if (distances_.too_near(met.values)) continue;
      Candidate found = candidate(assignment);
      if (!most.rank || found.rank <= *most.rank || solver.exact()) return {std::move(found), Ending::kNone};
      return {{}, Ending::kWrapped};
    } catch (const InternalError&) {
      if (solver.exact()) throw;
      // A model that is no execution, since ints wrapped in it. It must not come again.
      solver.add_clause(other_values(traced_.graph(), met.values, met.variables));
    }
  }
}

ExecutionSolver::Outcome TracingEngine::find(const BestFirst::Most& most) {
  ExecutionSolver& solver = traced_.solver();
  try {
    explore();
    while (true) {
      meet_pass();
      const std::size_t pass = solver.passes();
      const ExecutionSolver::Outcome outcome = solver.find([&] { return best_first_.at_most(most); });
      if (pass == solver.passes()) return outcome;
    }
  } catch (const Interrupted&) {
    return ExecutionSolver::Outcome::kStopped;
  }
}

void TracingEngine::meet_pass() {
  traced_.meet_pass();
  if (std::exchange(met_pass_, traced_.solver().passes()) == traced_.solver().passes()) return;
  best_first_.meet_pass();
  exclusion_.meet_pass();
}

Candidate TracingEngine::candidate(Assignment& assignment) {
  Execution execution = traced_.execution(assignment);
  Valuation values = values_of(execution);
  return {traced_.solution(std::move(execution)), std::move(values), best_first_.rank(assignment),
          best_first_.miss(assignment)};
}

void TracingEngine::remember(Valuation values) {
  exclusion_.add(std::move(values));
  if (met_pass_ > 0) exclusion_.tell_last();
}

void TracingEngine::tell_of_enumerated() {
  for (const auto& values : std::exchange(enumerated_, {})) exclusion_.add({values.begin(), values.end()});
  exclusion_.tell_all();
}

/// Returns true where solutions are all as good, no path is left unexplored, and none differ in auxiliary
/// choices alone.
bool TracingEngine::can_enumerate() {
  const Trace& trace = traced_.trace();
  if (!may_enumerate_ || !trace.blockers.empty() || trace.has_costs()) return false;
  if (!enumeration_) may_enumerate_ = follow_from_others(traced_.graph(), trace);
  return may_enumerate_;
}

/// Returns nothing if there is no solution left, or another way has to find it.
std::optional<Solution> TracingEngine::next_enumerated() {
  if (!can_enumerate()) return std::nullopt;
  if (!enumeration_) {
    const Stopwatch watch(traced_.solver().times().encode);
    enumeration_ = std::make_unique<Enumeration>(traced_.solver(), conditions(), options_.one_of_alike);
  }
  switch (enumerate()) {
    case Enumeration::Outcome::kFound:
      break;
    case Enumeration::Outcome::kNone:
      ending_ = Ending::kExhausted;
      return std::nullopt;
    case Enumeration::Outcome::kStopped:
      ending_ = Ending::kStopped;
      return std::nullopt;
    case Enumeration::Outcome::kTooHard:
      give_up_enumeration();
      return std::nullopt;
  }
  Assignment& assignment = enumeration_->assignment();
  Candidate found = candidate(assignment);
  enumerated_.emplace_back(found.values.begin(), found.values.end());
  return std::move(found.solution);
}

/// Goes to the next solution. Where the first one is hard to find for a search that does not learn, the
/// solver finds it.
Enumeration::Outcome TracingEngine::enumerate() {
  ExecutionSolver& solver = traced_.solver();
  const auto next = [&](std::uint64_t most_dead_ends) {
    const Stopwatch watch(solver.times().solve);
    return enumeration_->next(traced_.stop(), most_dead_ends);
  };
  const Enumeration::Outcome outcome =
      next(enumeration_->may_begin_near() ? tuning::kFewDeadEnds : tuning::kMostDeadEnds);
  if (outcome != Enumeration::Outcome::kTooHard || !enumeration_->may_begin_near()) return outcome;
  switch (solver.find([&] { return enumeration_->left_out(); })) {
    case ExecutionSolver::Outcome::kFound:
      break;
    case ExecutionSolver::Outcome::kNone:
      return Enumeration::Outcome::kNone;
    default:
      return Enumeration::Outcome::kStopped;
  }
  Assignment solution = solver.assignment();
  enumeration_->begin_near(solution);
  return next(tuning::kMostDeadEnds);
}

void TracingEngine::hear_of_alike() {
  ++alike_;
  const std::size_t came = exclusion_.size() + enumerated_.size();
  const std::size_t others = came - std::min(alike_, came);
  if (alike_ > tuning::kMostAlikePassedOver + others && enumeration_ &&
      says_what_is_seen(traced_.pass(), options_.apart))
    give_up_enumeration();
}

void TracingEngine::give_up_enumeration() {
  may_enumerate_ = false;
  enumeration_.reset();
  tell_of_enumerated();
}

Formula TracingEngine::formula_of_rest() {
  std::vector<NodeId> all = conditions();
  if (enumeration_) all.insert(all.end(), enumeration_->left_out().begin(), enumeration_->left_out().end());
  for (const TraceProgramError& error : traced_.trace().program_errors)
    all.push_back(traced_.graph().negation(error.guard));
  std::erase(all, kTrue);
  return {traced_.graph(), traced_.addresses(), std::move(all)};
}

/// Returns all that holds in the solutions that are left. A proof that there are none does without closed
/// sides, else it would be one of explored paths.
std::vector<NodeId> TracingEngine::conditions() {
  tell_of_enumerated();
  std::vector<NodeId> conditions = traced_.requirements(ending_ != Ending::kExhausted);
  for (const auto& more : {exclusion_.conditions(), distances_.conditions()})
    conditions.insert(conditions.end(), more.begin(), more.end());
  return conditions;
}

Valuation TracingEngine::addressed(const ChosenValues& choices) {
  Valuation values;
  for (const ChosenValue& choice : choices)
    values.emplace(traced_.addresses().address(choice.address), choice.value);
  return values;
}

}  // namespace solitaire
