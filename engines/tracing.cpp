#include "engines/tracing.h"

#include <algorithm>
#include <fmt/format.h>

#include "engines/random.h"
#include "smt/cadical_solver.h"
#include "smt/z3_solver.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

/// Adds the time until its end to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(StopSignal::Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_;
  StopSignal::Clock::time_point start_ = StopSignal::Clock::now();
};

using Answers = std::map<AddressId, std::pair<NodeId, std::int64_t>>;

/// Answers choices with the values of a model.
class ModelChoices : public Choices {
 public:
  ModelChoices(const Answers& answers, const AddressTable& addresses)
      : answers_(answers), addresses_(addresses) {}

  std::optional<std::int64_t> answer(AddressId address, const ChoiceDomain&) override {
    const auto it = answers_.find(address);
    if (it == answers_.end()) {
      throw InternalError("the replay met a choice that the model does not have: " +
                          addresses_.text(address));
    }
    return it->second.second;
  }

 private:
  const Answers& answers_;
  const AddressTable& addresses_;
};

}  // namespace

TracingEngine::TracingEngine(const Program& program, ParamValues params, const TracingOptions& options)
    : program_(program),
      params_(std::move(params)),
      options_(options),
      explorer_(program, params_, options.exploration, options.seed, options.limits, graph_, addresses_) {
  if (options_.limits.stop == nullptr) options_.limits.stop = &never_;
  const std::uint64_t solver_seed = RandomStream(options.seed, Purpose::kSolver, 0).next();
  solver_ = options.backend == Backend::kZ3
                ? make_z3_solver(graph_, addresses_, {solver_seed, options.diverse})
                : make_cadical_solver(graph_, {solver_seed});
}

TracingEngine::~TracingEngine() = default;

void TracingEngine::explore() {
  if (explorer_.passes() > 0) return;
  const Stopwatch watch(times_.explore);
  explorer_.start();
}

std::optional<Solution> TracingEngine::next() {
  try {
    explore();
    while (ending_ == Ending::kNone) {
      sync_solver();
      if (options_.diverse) suggest_values();
      switch (check(assumptions(true))) {
        case Verdict::kSatisfiable:
          return take_solution();
        case Verdict::kUnsatisfiable:
          if (!open_core()) return std::nullopt;
          break;
        case Verdict::kStopped:
          ending_ = Ending::kStopped;
          break;
      }
    }
  } catch (const Interrupted&) {
    ending_ = Ending::kStopped;
  }
  return std::nullopt;
}

bool TracingEngine::check_mistakes() {
  try {
    explore();
    sync_solver();
  } catch (const Interrupted&) {
    return false;
  }
  return !options_.limits.stop->stopped();
}

/// Tells the solver what the newest pass found. Conditions of earlier passes stay: each says something true
/// about the executions that its guard describes, whatever else has been opened since.
void TracingEngine::sync_solver() {
  if (synced_pass_ == explorer_.passes()) return;
  synced_pass_ = explorer_.passes();
  {
    const Stopwatch watch(times_.encode);
    for (const TraceAssert& condition : explorer_.pass().trace.asserts) {
      const NodeId required = graph_.implication(condition.guard, condition.condition);
      if (required != kTrue && required_.insert(required.index).second) solver_->add_clause({&required, 1});
    }
  }
  report_reachable_mistakes();
}

/// A solver that starts from random values of the choices ends at a solution near them, and not near the last
/// one.
void TracingEngine::suggest_values() {
  RandomChoices random(RandomStream(options_.seed, Purpose::kSuggest, solutions_));
  for (std::size_t i = 0; i < graph_.variables().size(); ++i) {
    const ChoiceVariable& variable = graph_.variables()[i];
    if (!solver_->suggest(i, *random.answer(variable.address, variable.domain))) return;
  }
}

std::vector<NodeId> TracingEngine::assumptions(bool with_mistakes) {
  const Trace& trace = explorer_.pass().trace;
  std::vector<NodeId> result;
  for (const TraceBlocker& blocker : trace.blockers) result.push_back(graph_.negation(blocker.guard));
  if (with_mistakes) {
    for (const TraceMistake& mistake : trace.mistakes) result.push_back(graph_.negation(mistake.guard));
  }
  std::sort(result.begin(), result.end(), [](NodeId a, NodeId b) { return a.index < b.index; });
  result.erase(std::unique(result.begin(), result.end()), result.end());
  std::erase(result, kTrue);
  return result;
}

Verdict TracingEngine::check(const std::vector<NodeId>& assumptions) {
  const Stopwatch watch(times_.solve);
  return solver_->check(assumptions, *options_.limits.stop);
}

/// A mistake that some execution makes is the program's error, whether or not other executions are solutions.
void TracingEngine::report_reachable_mistakes() {
  const Trace& trace = explorer_.pass().trace;
  if (trace.mistakes.empty()) return;
  NodeId any = kFalse;
  for (const TraceMistake& mistake : trace.mistakes) any = graph_.disjunction(any, mistake.guard);
  std::vector<NodeId> assumed = assumptions(false);
  assumed.push_back(any);
  if (check(assumed) != Verdict::kSatisfiable) return;
  Assignment assignment(graph_, [this](std::size_t variable) { return solver_->value(variable); });
  const auto met = std::find_if(trace.mistakes.begin(), trace.mistakes.end(),
                                [&](const TraceMistake& mistake) { return assignment.holds(mistake.guard); });
  if (met == trace.mistakes.end()) throw InternalError("a model that comes to a mistake comes to none");
  // The replay throws what a concrete execution reports.
  if (met->of_program && replay(model_choices()).rejection)
    throw InternalError("an execution that should come to a mistake was ruled out");
  throw ProgramError(Diagnostic{met->span, met->message, met->help, {}});
}

bool TracingEngine::open_core() {
  const std::vector<NodeId> core = solver_->core();
  const auto& blockers = explorer_.pass().trace.blockers;
  std::vector<std::size_t> in_core;
  for (std::size_t i = 0; i < blockers.size(); ++i) {
    if (std::find(core.begin(), core.end(), graph_.negation(blockers[i].guard)) != core.end())
      in_core.push_back(i);
  }
  if (in_core.empty()) {
    ending_ = Ending::kExhausted;
    return false;
  }
  const Stopwatch watch(times_.explore);
  if (!explorer_.open(in_core)) ending_ = Ending::kUnexplored;
  return ending_ == Ending::kNone;
}

/// The choices that exist in the model's execution.
Answers TracingEngine::model_choices() {
  Assignment assignment(graph_, [this](std::size_t variable) { return solver_->value(variable); });
  Answers answers;
  for (const TraceChoice& choice : explorer_.pass().trace.choices) {
    if (!assignment.holds(choice.guard)) continue;
    const bool added =
        answers.try_emplace(choice.address, choice.variable, assignment.value(choice.variable)->i).second;
    if (!added)
      throw InternalError("two choices of one execution share the address " +
                          addresses_.text(choice.address));
  }
  return answers;
}

Execution TracingEngine::replay(const Answers& answers) {
  const Stopwatch watch(times_.replay);
  ModelChoices choices(answers, addresses_);
  return execute(program_, params_, choices, addresses_, options_.limits);
}

Solution TracingEngine::take_solution() {
  const Answers answers = model_choices();
  Solution solution;
  solution.execution = replay(answers);
  if (const auto& rejection = solution.execution.rejection) {
    throw InternalError(
        fmt::format("a model fails in its replay at {}", program_.sources.place(rejection->span)));
  }
  solution.choices = solution.execution.choices;
  if (solution.choices.size() != answers.size()) {
    throw InternalError(
        fmt::format("a model has {} choices, its replay {}", answers.size(), solution.choices.size()));
  }
  add_object_choices(solution);
  forbid(answers);
  ++solutions_;
  return solution;
}

/// Section 4.2.3's all-different constraint: some choice of the solution has another value. That is
/// path-sensitive as it stands. An execution is determined by the choices that it meets, so one that differs
/// from the solution meets the same choices up to one that both have and answer differently, which satisfies
/// the clause; and one that does not differ satisfies none of it. Choices that do not exist on a path
/// therefore never make two solutions differ, and need no reserved value to be kept from it.
void TracingEngine::forbid(const Answers& answers) {
  const Stopwatch watch(times_.encode);
  std::vector<NodeId> differs;
  for (const auto& [address, answer] : answers) {
    const auto& [variable, value] = answer;
    const NodeId equal = graph_.apply(Op::kEqInt, {variable, graph_.constant(value)});
    if (equal != kTrue) differs.push_back(graph_.negation(equal));
  }
  solver_->add_clause(differs);
}

}  // namespace solitaire
