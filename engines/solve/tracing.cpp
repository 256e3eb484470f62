#include "engines/solve/tracing.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <utility>

#include "base/hash.h"
#include "engines/distinct.h"
#include "engines/solve/met_choices.h"
#include "engines/solve/objective.h"
#include "engines/solve/symmetry.h"
#include "engines/solve/wide_trace.h"
#include "engines/thesis/all_different.h"
#include "solitaire/run/trace_reading.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

/// Passes that look for choices that a pin names before it counts as a mistake.
constexpr std::size_t kPassesForPins = 8;

/// Answers choices with the values of a model.
class ModelChoices : public Choices {
 public:
  ModelChoices(const Answers& answers, const AddressTable& addresses)
      : answers_(answers), addresses_(addresses) {}

  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    const auto it = answers_.find(address);
    if (it == answers_.end()) {
      throw InternalError("the replay met a choice that the model does not have: " +
                          addresses_.text(address));
    }
    return domain.typed(it->second.second);
  }

 private:
  const Answers& answers_;
  const AddressTable& addresses_;
};

/// Answers choices with those of a solution that was written down.
class WrittenChoices : public Choices {
 public:
  WrittenChoices(const KnownChoices& choices, const AddressTable& addresses) : addresses_(addresses) {
    for (const AnsweredChoice& choice : choices) values_.emplace(choice.address, choice.value);
  }

  std::optional<TypedScalar> answer(AddressId address, const Distribution&) override {
    const auto it = values_.find(addresses_.text(address));
    if (it == values_.end()) throw NotASolution("it has no choice " + addresses_.text(address));
    return it->second;
  }

 private:
  const AddressTable& addresses_;
  std::unordered_map<std::string, TypedScalar> values_;
};

ExecutionSolver::Firm firmness(bool relax) {
  return [relax](const TraceAssert& condition) {
    return !relax || condition.requirement != ConstraintKind::kAssert;
  };
}

TracingOptions for_solver(TracingOptions options, const StopSignal& stop) {
  options.limits.stop = &stop;
  options.limits.keep_going = options.relax;
  return options;
}

NodeId checked_objective(Graph& graph, const Trace& trace, bool relax) {
  try {
    return objective_of(graph, trace, relax);
  } catch (const IntegerTooLarge&) {
    throw ProgramError(
        Diagnostic{trace.wishes.front().span, "the cost of all wishes can grow past 62 bits", "", {}});
  }
}

bool is_power_of_16(std::uint64_t number) {
  return std::has_single_bit(number) && std::countr_zero(number) % 4 == 0;
}

ChoiceValues values_of(const Answers& answers) {
  ChoiceValues values;
  for (const auto& [address, answer] : answers) values.emplace_hint(values.end(), address, answer.second);
  return values;
}

ChoiceValues values_of(const Solution& solution) {
  ChoiceValues values;
  for (const MetChoice& choice : solution.choices) values.emplace(choice.address, choice.value.as_int());
  return values;
}

std::uint64_t hash_of(const ChoiceValues& values) {
  std::uint64_t hash = values.size();
  for (const auto& [address, value] : values)
    hash = mix(mix(hash, address.index), static_cast<std::uint64_t>(value));
  return hash;
}

std::size_t count_broken(const Execution& execution) {
  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t>> broken;
  for (const Rejection& each : execution.broken) {
    broken.emplace(each.address, each.whole.source, each.whole.begin);
  }
  return broken.size();
}

}  // namespace

TracingEngine::TracingEngine(const Program& program, ParamValues params, const TracingOptions& options,
                             std::uint64_t first)
    : program_(program),
      params_(std::move(params)),
      options_(options),
      limits_(options.limits),
      solution_stop_(options.limits.stop),
      pins_(options.pins, addresses_),
      choices_(pins_),
      solver_(program, params_, for_solver(options, solution_stop_), choices_, graph_, addresses_,
              firmness(options.relax), first),
      may_enumerate_(!options.diverse && !options.relax && options.backend == Backend::kCadical &&
                     !options.min_distance.any()),
      taken_(first),
      number_(first) {
  limits_.keep_going = options.relax;
}

TracingEngine::~TracingEngine() = default;

Ending TracingEngine::ending_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::kFound:
      return Ending::kNone;
    case Outcome::kNone:
      return Ending::kExhausted;
    case Outcome::kUnexplored:
      return Ending::kUnexplored;
    case Outcome::kWrapped:
      return Ending::kWrapped;
    case Outcome::kStopped:
      break;
  }
  return Ending::kStopped;
}

std::optional<Solution> TracingEngine::next() {
  if (ending_ != Ending::kNone) return std::nullopt;
  const auto start = StopSignal::Clock::now();
  try {
    solver_.explore();
    if (may_enumerate_) {
      meet_pass();
      std::optional<Solution> solution = next_enumerated();
      if (solution || ending_ != Ending::kNone) return solution;
    }
  } catch (const Interrupted&) {
    ending_ = Ending::kStopped;
    return std::nullopt;
  }
  if (options_.diverse) solver_.suggest_random_values(number_++);
  std::optional<Found> best;
  if (last_was_best_) best = attempt(proved_);  // perhaps there is another one as good
  if (!best && ending_ != Ending::kStopped) {
    ending_ = Ending::kNone;
    best = attempt(std::nullopt);
  }
  if (!best) return std::nullopt;
  improve(*best, start);
  remember(values_of(best->solution));
  return std::move(best->solution);
}

void TracingEngine::remember(ChoiceValues values) {
  by_hash_.emplace(hash_of(values), known_.size());
  known_.push_back({std::move(values), {}});
  if (met_pass_ > 0 && !enumerator_ && excludes_at_once()) exclude_known(known_.back());
}

/// Whether the solver is told of every known solution. To find one again by chance and tell the solver then
/// is less work where that is rare: where solutions are many, and drawn at random.
bool TracingEngine::excludes_at_once() const {
  constexpr std::size_t kFewKnown = 16;
  const bool best_first = options_.relax || !solver_.trace().wishes.empty();
  return !options_.diverse || options_.backend == Backend::kThesis || best_first ||
         4 * repeated_ > known_.size() + kFewKnown;
}

/// Whether the model is a known solution; then the solver is told of it, and has to be asked again.
bool TracingEngine::exclude_repeated(const ChoiceValues& values) {
  const auto [begin, end] = by_hash_.equal_range(hash_of(values));
  const auto found =
      std::find_if(begin, end, [&](const auto& entry) { return known_[entry.second].values == values; });
  if (found == end) return false;
  Known& known = known_[found->second];
  if (known.differs) throw InternalError("a model repeats a solution that is excluded");
  exclude_known(known);
  ++repeated_;
  if (excludes_at_once()) exclude_all_known();
  return true;
}

void TracingEngine::exclude_all_known() {
  for (Known& known : known_) exclude_known(known);
}

/// Where the solutions are all as good, and no path is left unexplored.
bool TracingEngine::can_enumerate() const {
  return may_enumerate_ && solver_.trace().blockers.empty() && solver_.trace().wishes.empty();
}

/// Nothing if there is none, or another way has to find it.
std::optional<Solution> TracingEngine::next_enumerated() {
  if (!can_enumerate()) return std::nullopt;
  if (!enumerator_) enumerator_ = make_enumerator();
  const Enumerator::Outcome outcome = [&] {
    const Stopwatch watch(solver_.times().solve);
    return enumerator_->next(solution_stop_);
  }();
  switch (outcome) {
    case Enumerator::Outcome::kFound:
      break;
    case Enumerator::Outcome::kNone:
      ending_ = Ending::kExhausted;
      return std::nullopt;
    case Enumerator::Outcome::kStopped:
      ending_ = Ending::kStopped;
      return std::nullopt;
    case Enumerator::Outcome::kTooHard:
      may_enumerate_ = false;
      enumerator_.reset();
      breaking_.clear();
      exclude_all_known();
      return std::nullopt;
  }
  Assignment assignment(graph_,
                        [this](std::size_t variable) { return Scalar::of(enumerator_->value(variable)); });
  Solution solution = run(std::move(assignment));
  remember(values_of(solution));
  return solution;
}

std::unique_ptr<Enumerator> TracingEngine::make_enumerator() {
  const Stopwatch watch(solver_.times().encode);
  const MetChoices met = met_choices(graph_, solver_.trace());
  std::vector<NodeId> conditions = formula();
  const std::vector<NodeId> fixed = fixed_unmet_choices(graph_, met);
  conditions.insert(conditions.end(), fixed.begin(), fixed.end());
  if (options_.one_of_alike) {
    breaking_ = symmetry_breaking(graph_, addresses_, solver_.pass(), conditions);
    conditions.insert(conditions.end(), breaking_.begin(), breaking_.end());
  }
  std::erase(conditions, kTrue);
  std::vector<std::size_t> choices;
  for (const auto& [variable, guard] : met) choices.push_back(variable);
  return std::make_unique<Enumerator>(graph_, conditions, choices);
}

/// Makes the solution better until it is proved that no better one is left, or a limit comes.
void TracingEngine::improve(Found& best, StopSignal::Clock::time_point start) {
  // What a trace says of the cost is all there is to say only where no path is left unexplored.
  const bool explored = solver_.trace().blockers.empty();
  const bool no_wishes = solver_.trace().wishes.empty();
  if (graph_.node(objective_).is_constant() && (explored || no_wishes)) {
    if (best.solution.quality) best.solution.quality->proved = true;
    return;
  }
  if (options_.improvement_time) {
    const std::chrono::duration<double> time(std::min(*options_.improvement_time, 1e8));
    solution_stop_.set_deadline(start + std::chrono::duration_cast<StopSignal::Clock::duration>(time));
  }
  if (explored) proved_ = std::max(proved_, graph_.node(objective_).interval.lo);
  std::int64_t stride = 1;  // towards what is impossible, while it is not known where that is
  while (best.rank > proved_) {
    if (told_) told_(best.solution);
    std::int64_t target = std::max(best.rank - stride, -kIntLimit);
    if (proved_ != INT64_MIN) {
      target = proved_ + (best.rank - 1 - proved_) / 2;
    } else if (stride < kIntLimit / 4) {
      stride *= 2;
    }
    if (std::optional<Found> better = attempt(target)) {
      best = std::move(*better);
    } else if (ending_ == Ending::kExhausted) {
      proved_ = target + 1;
    } else {
      break;  // the next search will find whether it has to end
    }
  }
  last_was_best_ = best.rank <= proved_;
  best.solution.quality->proved = last_was_best_;
  ending_ = Ending::kNone;
  solution_stop_.set_deadline(StopSignal::Clock::time_point::max());
}

/// A solution of at most that rank; if there is none, ending_ says why.
std::optional<TracingEngine::Found> TracingEngine::attempt(std::optional<std::int64_t> most) {
  while (true) {
    const Outcome outcome = find(most);
    ending_ = ending_of(outcome);
    if (outcome != Outcome::kFound) return std::nullopt;
    Assignment assignment = solver_.assignment();
    const Answers answers = solver_.answers(assignment);
    const ChoiceValues values = values_of(answers);
    if (exclude_repeated(values)) continue;
    try {
      if (require_distance(values)) continue;
      Found found = take_solution(assignment);
      if (!most || found.rank <= *most || solver_.exact()) return found;
      ending_ = Ending::kWrapped;
      return std::nullopt;
    } catch (const InternalError&) {
      if (solver_.exact()) throw;
      exclude_model(answers);
    }
  }
}

/// Whether the model is too near to solutions to keep away from; then the solver is told of these, and has to
/// be asked again. To tell it of all from the start would slow it down for what most models fulfil by chance.
bool TracingEngine::require_distance(const ChoiceValues& values) {
  bool near = false;
  for (KeptAway& kept : kept_away_) {
    if (options_.min_distance.reached(overlap_of(values, kept.values))) continue;
    if (std::exchange(kept.told_in_pass, met_pass_) == met_pass_)
      throw InternalError("a model is nearer to an earlier solution than its constraint allows");
    const Stopwatch watch(solver_.times().encode);
    const NodeId condition = distance_condition(kept);
    solver_.add_clause({&condition, 1});
    near = true;
  }
  return near;
}

/// The choices of an execution that leaves the paths explored so far are not known.
NodeId TracingEngine::distance_condition(const KeptAway& kept) {
  return graph_.disjunction(far_from(graph_, solver_.trace(), kept.values, options_.min_distance),
                            solver_.unexplored());
}

/// Keeps the solver from a model that is no execution, since ints wrapped in it.
void TracingEngine::exclude_model(const Answers& answers) { solver_.add_clause(differing(answers)); }

TracingEngine::Outcome TracingEngine::find(std::optional<std::int64_t> most) {
  try {
    solver_.explore();
    while (true) {
      meet_pass();
      const Outcome outcome = solver_.find([&]() -> std::vector<NodeId> {
        if (!most) return {};
        const NodeId objective = checked_objective(graph_, solver_.trace(), options_.relax);
        const NodeId good = graph_.apply(Op::kLeInt, {objective, graph_.constant(*most)});
        return {graph_.disjunction(good, solver_.unexplored())};
      });
      if (met_pass_ == solver_.passes()) return outcome;
    }
  } catch (const Interrupted&) {
    return Outcome::kStopped;
  }
}

/// What has to be done anew for each pass, before its executions are solutions.
void TracingEngine::meet_pass() {
  if (met_pass_ == solver_.passes()) return;
  if (met_pass_ == 0) check_pins();
  met_pass_ = solver_.passes();
  for (const PinnedChoice& pinned : pinned_choices(graph_, solver_.trace(), pins_)) {
    if (pinned.holds != kTrue) solver_.add_clause({&pinned.holds, 1});
  }
  if (options_.backend == Backend::kThesis) {
    for (const NodeId condition : reserved_values(graph_, solver_.trace()))
      solver_.add_clause({&condition, 1});
  }
  if (!options_.relax) report_reachable_mistakes();
  objective_ = checked_objective(graph_, solver_.trace(), options_.relax);
  const bool all = excludes_at_once();
  for (Known& known : known_) {
    if (all || known.differs) exclude_known(known);
  }
}

bool TracingEngine::check_mistakes() {
  try {
    solver_.explore();
    meet_pass();
  } catch (const Interrupted&) {
    return false;
  }
  return options_.limits.stop == nullptr || !options_.limits.stop->stopped();
}

bool TracingEngine::explore_fully() {
  solver_.explore();
  meet_pass();  // a mistake that is known by now ends the search before it goes far
  const bool complete = solver_.explore_fully(kMostPasses);
  meet_pass();
  return complete;
}

/// A pin that matches no choice is a mistake of the user's, unless that choice stands on a path that was not
/// explored yet.
void TracingEngine::check_pins() {
  if (pins_.empty()) return;
  const auto unmatched = [this] {
    std::vector<AddressId> addresses;
    for (const TraceChoice& choice : solver_.trace().choices) addresses.push_back(choice.address);
    return pins_.unmatched(addresses);
  };
  if (unmatched().empty()) return;
  solver_.explore_fully(kPassesForPins);
  const std::vector<const Pin*> wrong = unmatched();
  if (wrong.empty()) return;
  std::vector<std::vector<std::string>> known;
  for (const TraceChoice& choice : solver_.trace().choices) known.push_back(addresses_.steps(choice.address));
  const std::vector<std::string> nearest = nearest_patterns(wrong.front()->pattern, known, 3);
  throw UnmatchedPin(nearest.empty() ? fmt::format("{}: the program has no choices", wrong.front()->source)
                                     : fmt::format("{}: no choice has such an address; the nearest {} {}",
                                                   wrong.front()->source, nearest.size() == 1 ? "is" : "are",
                                                   fmt::join(nearest, ", ")));
}

/// A mistake that some execution makes is the program's error, whether or not other executions are solutions.
void TracingEngine::report_reachable_mistakes() {
  const Trace& trace = solver_.trace();
  if (trace.program_errors.empty()) return;
  NodeId any = kFalse;
  for (const TraceProgramError& mistake : trace.program_errors) any = graph_.disjunction(any, mistake.guard);
  const Outcome outcome = solver_.find_explored([&] { return std::vector{any}; });
  if (outcome != Outcome::kFound || !solver_.exact()) return;  // wrapped ints come to it, perhaps
  Assignment assignment = solver_.assignment();
  const auto met =
      std::find_if(trace.program_errors.begin(), trace.program_errors.end(),
                   [&](const TraceProgramError& mistake) { return assignment.holds(mistake.guard); });
  if (met == trace.program_errors.end()) throw InternalError("a model that comes to a mistake comes to none");
  throw ProgramError(diagnose(*met));
}

/// A mistake that the solver's model comes to, as a concrete execution reports it.
Diagnostic TracingEngine::diagnose(const TraceProgramError& mistake) {
  if (!mistake.of_program) return {mistake.span, mistake.message, mistake.help, {}};
  try {
    replay(solver_.answers());
  } catch (const ProgramError& error) {
    return error.diagnostics().front();
  }
  throw InternalError("an execution that should come to a mistake came to none");
}

std::vector<Diagnostic> TracingEngine::find_mistakes(bool* complete) {
  std::vector<Diagnostic> diagnostics;
  try {
    *complete = solver_.explore_fully();
  } catch (const Interrupted&) {
    *complete = false;
  }
  const Trace& trace = solver_.trace();
  std::vector<bool> told(trace.program_errors.size(), false);
  while (true) {
    const Outcome outcome = solver_.find_explored([&] {
      NodeId any = kFalse;
      for (std::size_t i = 0; i < told.size(); ++i) {
        if (!told[i]) any = graph_.disjunction(any, trace.program_errors[i].guard);
      }
      return std::vector{any};
    });
    if (outcome != Outcome::kFound) {
      *complete &= outcome == Outcome::kNone;
      return diagnostics;
    }
    Assignment assignment = solver_.assignment();
    std::size_t number = 0;
    while (told[number] || !assignment.holds(trace.program_errors[number].guard)) ++number;
    const TraceProgramError& met = trace.program_errors[number];
    diagnostics.push_back(diagnose(met));
    diagnostics.back().notes.push_back(leading_choices(met, solver_.answers(assignment)));
    for (std::size_t i = 0; i < told.size(); ++i) {  // the same mistake on other paths says nothing new
      if (trace.program_errors[i].span == met.span && trace.program_errors[i].message == met.message)
        told[i] = true;
    }
  }
}

/// "where x = 3, f = true": the choices on which it depends whether an execution comes to the mistake.
std::string TracingEngine::leading_choices(const TraceProgramError& mistake, const Answers& answers) const {
  std::vector<std::string> choices;
  for (const std::size_t number : variables_below(graph_, {&mistake.guard, 1})) {
    const ChoiceVariable& variable = graph_.variables()[number];
    const auto answer = answers.find(variable.address);
    if (answer == answers.end()) continue;
    const std::int64_t value = answer->second.second;
    choices.push_back(fmt::format("{} = {}", addresses_.text(variable.address),
                                  variable.domain.family == Distribution::Family::kFlip
                                      ? (value != 0 ? "true" : "false")
                                      : fmt::to_string(value)));
  }
  return choices.empty() ? "whatever is chosen" : fmt::format("where {}", fmt::join(choices, ", "));
}

Execution TracingEngine::replay(const Answers& answers) {
  const Stopwatch watch(solver_.times().replay);
  ++solver_.times().replays;
  ModelChoices choices(answers, addresses_);
  return execute(program_, params_, choices, addresses_, limits_);
}

/// Reads an execution off the trace. Returns nothing if the execution has to be run instead.
std::optional<Execution> TracingEngine::read(Assignment& assignment) {
  const bool first = ++taken_ == 1;
  if (first || options_.replay == Replay::kEvery || options_.relax || options_.backend == Backend::kThesis)
    return std::nullopt;
  const Stopwatch watch(solver_.times().replay);
  return read_execution(program_, solver_.pass(), addresses_, assignment,
                        options_.scene != SceneDetail::kNone);
}

/// Nobody should believe what is never looked at: the program is run, too, now and then.
void TracingEngine::check_reading(const Execution& read, Assignment& assignment) {
  if (!is_power_of_16(taken_)) return;
  const Execution run = replay(solver_.answers(assignment));
  const auto same_choice = [](const MetChoice& a, const MetChoice& b) {
    return a.address == b.address && a.value == b.value;
  };
  const bool alike = !run.rejection && std::ranges::equal(read.choices, run.choices, same_choice) &&
                     read.cost == run.cost && to_json(read.value) == to_json(run.value) &&
                     (options_.scene == SceneDetail::kNone || looks_of(read) == looks_of(run));
  if (!alike) throw InternalError("a solution is not what the trace says of it");
}

/// Throws InternalError if the model is not an execution.
TracingEngine::Found TracingEngine::take_solution(Assignment& assignment) {
  Found found;
  Solution& solution = found.solution;
  if (std::optional<Execution> execution = read(assignment)) {
    check_reading(*execution, assignment);
    solution.execution = std::move(*execution);
  } else {
    const Answers answers = solver_.answers(assignment);
    solution.execution = replay(answers);
    if (const auto& rejection = solution.execution.rejection) {
      throw InternalError(
          fmt::format("a model fails in its replay at {}", program_.sources.place(rejection->span)));
    }
    if (solution.execution.choices.size() != answers.size()) {
      throw InternalError(fmt::format("a model has {} choices, its replay {}", answers.size(),
                                      solution.execution.choices.size()));
    }
  }
  solution.choices = solution.execution.choices;
  found.rank = assignment.value(objective_)->i;
  complete(solution);
  return found;
}

void TracingEngine::complete(Solution& solution) {
  solution.answers = readable(solution.choices, addresses_);
  const Execution& execution = solution.execution;
  if (options_.relax || !solver_.trace().wishes.empty())
    solution.quality = Quality{count_broken(execution), execution.cost};
  if (options_.scene == SceneDetail::kProvenance) add_object_choices(solution);
  add_broken_choices(solution);
}

void TracingEngine::exclude(const KnownChoices& choices) { remember(addressed(choices)); }

void TracingEngine::keep_away_from(const KnownChoices& choices) {
  if (!options_.min_distance.any()) return;
  kept_away_.push_back({addressed(choices)});
}

ChoiceValues TracingEngine::addressed(const KnownChoices& choices) {
  ChoiceValues values;
  for (const AnsweredChoice& choice : choices)
    values.emplace(addresses_.address(choice.address), choice.value.as_int());
  return values;
}

/// Whether the values are `possible` for the graph's choices is known once it has been asked for all of them.
Assignment TracingEngine::assignment_of(const ChoiceValues& values, bool& possible) const {
  return {graph_, [this, &values, &possible](std::size_t number) {
            const ChoiceVariable& variable = graph_.variables()[number];
            const auto value = values.find(variable.address);
            if (value == values.end()) return Scalar::of(variable.domain.lo);
            possible = possible && variable.domain.contains(value->second);
            return Scalar::of(value->second);
          }};
}

Solution TracingEngine::run(const KnownChoices& choices) {
  solver_.explore();
  Solution solution;
  if (std::optional<Execution> execution = read(choices)) {
    solution.execution = std::move(*execution);
  } else {
    const Stopwatch watch(solver_.times().replay);
    ++solver_.times().replays;
    WrittenChoices written(choices, addresses_);
    solution.execution = execute(program_, params_, written, addresses_, limits_);
  }
  if (solution.execution.rejection) throw NotASolution("a condition of the program does not hold");
  if (solution.execution.choices.size() != choices.size())
    throw NotASolution("it has choices that the program does not have");
  solution.choices = solution.execution.choices;
  complete(solution);
  return solution;
}

/// Nothing, too, where the choices are not those that the execution meets.
std::optional<Execution> TracingEngine::read(const KnownChoices& choices) {
  const ChoiceValues values = addressed(choices);
  bool possible = true;
  Assignment assignment = assignment_of(values, possible);
  std::optional<Execution> execution = read(assignment);
  const auto known = [&](const MetChoice& choice) {
    const auto value = values.find(choice.address);
    return value != values.end() && value->second == choice.value.as_int();
  };
  if (!possible || !execution || execution->choices.size() != choices.size() ||
      !std::ranges::all_of(execution->choices, known))
    return std::nullopt;
  check_reading(*execution, assignment);
  return execution;
}

Solution TracingEngine::run(Assignment assignment) { return take_solution(assignment).solution; }

std::vector<NodeId> TracingEngine::formula() {
  exclude_all_known();
  const Trace& trace = solver_.trace();
  std::vector<NodeId> conditions;
  const ExecutionSolver::Firm firm = firmness(options_.relax);
  for (const TraceAssert& required : trace.asserts) {
    if (firm(required)) conditions.push_back(graph_.implication(required.guard, required.condition));
  }
  for (const PinnedChoice& pinned : pinned_choices(graph_, trace, pins_)) conditions.push_back(pinned.holds);
  if (ending_ != Ending::kExhausted) {  // the proof does without them, else it would be one of explored paths
    for (const TraceBlocker& blocker : trace.blockers) conditions.push_back(graph_.negation(blocker.guard));
  }
  for (const TraceProgramError& mistake : trace.program_errors)
    conditions.push_back(graph_.negation(mistake.guard));
  for (const Known& known : known_) {
    if (!known.differs) continue;
    NodeId differs = kFalse;
    for (const NodeId one : *known.differs) differs = graph_.disjunction(differs, one);
    conditions.push_back(differs);
  }
  for (const KeptAway& kept : kept_away_) conditions.push_back(distance_condition(kept));
  conditions.insert(conditions.end(), breaking_.begin(), breaking_.end());
  std::erase(conditions, kTrue);
  return conditions;
}

std::vector<NodeId> TracingEngine::differing(const Answers& answers) {
  std::vector<NodeId> differs;
  for (const auto& [address, answer] : answers) {
    const NodeId equal = graph_.apply(Op::kEqInt, {answer.first, graph_.constant(answer.second)});
    if (equal != kTrue) differs.push_back(graph_.negation(equal));
  }
  return differs;
}

/// Section 4.2.3's all-different constraint: some choice of the solution has another value. That is
/// path-sensitive as it stands. An execution is determined by the choices that it meets, so one that differs
/// from the solution meets the same choices up to one that both have and answer differently, which satisfies
/// the clause; and one that does not differ satisfies none of it. Choices that do not exist on a path
/// therefore never make two solutions differ, and need no reserved value to be kept from it.
///
/// Which variable of the graph stands for a choice can change with the pass, since the domain of one whose
/// ends depend on other choices grows with the paths that are open.
void TracingEngine::exclude_known(Known& known) {
  const Stopwatch watch(solver_.times().encode);
  bool possible = true;
  Assignment assignment = assignment_of(known.values, possible);
  bool explored = false;
  const Answers answers = solver_.answers(assignment, &explored);
  if (!explored) return;  // it cannot be found yet
  const bool as_stated = options_.backend == Backend::kThesis;
  std::vector<NodeId> differs =
      as_stated ? differences(graph_, solver_.trace(), known.values) : differing(answers);
  if (known.differs == differs) return;
  solver_.add_clause(differs);
  known.differs = std::move(differs);
}

}  // namespace solitaire
