#include "engines/solve/executions/execution_solver.h"

#include <algorithm>
#include <map>
#include <unordered_set>

#include "engines/errors.h"
#include "engines/random_choices.h"
#include "engines/solve/conclusions/over_full.h"
#include "engines/solve/conclusions/permutations.h"
#include "engines/solve/conclusions/sum_conflict.h"
#include "engines/tuning.h"

namespace solitaire {

ExecutionSolver::ExecutionSolver(const Program& program, ParamValues params, const TracingOptions& options,
                                 Choices& choices, Graph& graph, AddressTable& addresses, Firm firm,
                                 std::uint64_t stream)
    : graph_(graph),
      addresses_(addresses),
      options_(options),
      firm_(std::move(firm)),
      explorer_(program, std::move(params), options.exploration, options.seed, options.limits, choices, graph,
                addresses) {
  const SearchMethod& method = *options.method;
  if (method.asserts_closed_sides() && options.exploration.policy != Exploration::Policy::kRandom)
    throw std::logic_error("a method that asserts closed sides explores at random");
  if (options_.limits.stop == nullptr) options_.limits.stop = &never_;
  const std::uint64_t seed = RandomStream(options.seed, Purpose::kSolver, stream).next();
  solver_ = method.make_solver(graph_, addresses_, {seed, options.diverse, options.far_apart});
  if (options.effort > 0) solver_->limit_effort(options.effort);
}

ExecutionSolver::~ExecutionSolver() = default;

void ExecutionSolver::explore() {
  if (explorer_.passes() == 0) {
    const Stopwatch watch(times_.explore);
    explorer_.start();
  }
  sync();
}

bool ExecutionSolver::count_least_steps() {
  if (explorer_.counts_least_steps()) return false;
  {
    const Stopwatch watch(times_.explore);
    explorer_.count_least_steps();
  }
  sync();
  return true;
}

/// Tells the solver what the newest pass found. Conditions of earlier passes stay: each says something true
/// about the executions that its guard describes, whatever else has been opened since.
void ExecutionSolver::sync() {
  if (synced_pass_ == explorer_.passes()) return;
  synced_pass_ = explorer_.passes();
  const Stopwatch watch(times_.encode);
  // First, so that what takes part gets variables of its own, and the clause is broken as soon as they are
  // true.
  if (!options_.method->asserts_closed_sides()) tell_over_full();
  for (const Term& term : trace().hard_terms) {
    if (!firm_(term)) continue;
    tell_required(graph_.implication(term.guard, term.node));
  }
  if (!options_.method->asserts_closed_sides()) return;
  for (const TraceBlocker& blocker : trace().blockers) require(graph_.negation(blocker.guard));
}

/// Tells the solver of a condition, but not of those of its conjuncts that rule out what is ruled out anyway.
void ExecutionSolver::tell_required(NodeId required) {
  std::vector<NodeId> pending{required};
  while (!pending.empty()) {
    const NodeId next = pending.back();
    pending.pop_back();
    const Graph::Node& node = graph_.node(next);
    if (node.op == Op::kAnd && !ruled_out_.empty()) {
      pending.insert(pending.end(), {node.operands[1], node.operands[0]});
    } else if (next != kTrue && (node.op != Op::kNot || !ruled_out_.contains(node.operands[0])) &&
               required_.insert(next.index).second) {
      solver_->add_clause({&next, 1});
    }
  }
}

/// Tells the solver which conditions cannot hold together since there is too little room, which it would find
/// out in very many steps, or never. These clauses are true of all ints, whatever is required.
void ExecutionSolver::tell_over_full() {
  std::vector<NodeId> required, others;
  for (const Term& term : trace().hard_terms)
    (term.guard == kTrue && firm_(term) ? required : others).push_back(term.node);
  Separations separations = find_separations(graph_, required);
  comparisons_ = separations.comparisons;
  const Permutations permutations = find_permutations(graph_, separations);
  ruled_out_ = permutations.ruled_out;
  for (const NodeId condition : permutations.values) require(condition);
  implied_ = permutations.taken;
  implied_sums_ = permutations.sums;
  for (const NodeId sum : implied_sums_) comparisons_.push_back({sum});
  add_separations(graph_, others, separations);
  for (const OverFull& found : find_over_full(graph_, separations)) tell(found);
}

/// Does the same for sums that ask for more than others allow, if what is required and assumed says so. After
/// some looks in vain at what is assumed it looks more and more rarely: a search for the best can ask
/// hundreds of questions.
void ExecutionSolver::tell_sum_conflict(const std::vector<NodeId>& assumptions) {
  if (options_.method->asserts_closed_sides()) return;
  if (counted_pass_ == synced_pass_ && (assumptions.empty() || questions_to_skip_-- > 0)) return;
  counted_pass_ = synced_pass_;
  std::vector<SignedNode> comparisons = comparisons_;
  const Separations assumed = find_separations(graph_, assumptions);
  comparisons.insert(comparisons.end(), assumed.comparisons.begin(), assumed.comparisons.end());
  const auto found = find_sum_conflict(graph_, comparisons);
  sums_in_vain_ = found ? 0 : sums_in_vain_ + 1;
  questions_to_skip_ = (std::int64_t{1} << std::min(sums_in_vain_ / 2, 20)) - 1;
  if (!found) return;
  for (const NodeId sum : implied_sums_) require(sum);  // the solver needs them for this alone
  tell(*found);
}

void ExecutionSolver::tell(const OverFull& conflict) {
  std::vector<NodeId> clause;
  for (const NodeId condition : conflict.conditions) clause.push_back(graph_.negation(condition));
  solver_->add_clause(clause);
}

void ExecutionSolver::suggest_random_values(std::uint64_t index) {
  RandomChoices random(RandomStream(options_.seed, Purpose::kSuggest, index));
  for (std::size_t i = 0; i < graph_.variables().size(); ++i) {
    const ChoiceVariable& variable = graph_.variables()[i];
    const TypedScalar value = *random.answer(variable.address, variable.domain);
    if (!variable.domain.is_finite()) continue;
    if (!solver_->suggest(i, value.as_int())) return;
  }
}

NodeId ExecutionSolver::unexplored() {
  NodeId any = kFalse;
  for (const TraceBlocker& blocker : trace().blockers) any = graph_.disjunction(any, blocker.guard);
  return any;
}

std::vector<NodeId> ExecutionSolver::closed_sides(Ends ends) const {
  std::vector<NodeId> closed;
  if (options_.method->asserts_closed_sides()) return closed;
  for (const TraceBlocker& blocker : trace().blockers) {
    if (ends == Ends::kErrorsAndCuts && blocker.side.kind == BranchSide::Kind::kCut) continue;
    closed.push_back(graph_.negation(blocker.guard));
  }
  return closed;
}

Verdict ExecutionSolver::check(std::vector<NodeId> assumptions) {
  std::sort(assumptions.begin(), assumptions.end(), [](NodeId a, NodeId b) { return a.index < b.index; });
  assumptions.erase(std::unique(assumptions.begin(), assumptions.end()), assumptions.end());
  std::erase(assumptions, kTrue);
  const Stopwatch watch(times_.solve);
  const Verdict verdict = solver_->check(assumptions, *options_.limits.stop);
  if (verdict == Verdict::kUnsatisfiable) core_ = solver_->core();
  return verdict;
}

ExecutionSolver::Outcome ExecutionSolver::find(const Conditions& conditions, Ends ends) {
  const auto without_errors = [&] {
    std::vector<NodeId> all = conditions();
    if (ends != Ends::kNone) return all;
    for (const TraceProgramError& error : trace().program_errors) all.push_back(graph_.negation(error.guard));
    return all;
  };
  while (true) {
    const Outcome outcome = find_explored(without_errors, ends);
    if (outcome != Outcome::kNone) return outcome;
    const std::vector<std::size_t> in_the_way = blockers_in_core();
    if (in_the_way.empty()) {
      if (options_.method->asserts_closed_sides() && !trace().blockers.empty()) return Outcome::kUnexplored;
      return solver_->exact() ? Outcome::kNone : Outcome::kWrapped;
    }
    try {
      if (!open(in_the_way)) return Outcome::kUnexplored;
    } catch (const Interrupted&) {
      return Outcome::kStopped;
    }
  }
}

ExecutionSolver::Outcome ExecutionSolver::find_explored(const Conditions& conditions, Ends ends) {
  try {
    explore();
  } catch (const Interrupted&) {
    return Outcome::kStopped;
  }
  std::vector<NodeId> assumptions = conditions();
  tell_sum_conflict(assumptions);
  const std::vector<NodeId> closed = closed_sides(ends);
  assumptions.insert(assumptions.end(), closed.begin(), closed.end());
  switch (check(std::move(assumptions))) {
    case Verdict::kSatisfiable:
      return Outcome::kFound;
    case Verdict::kUnsatisfiable:
      return Outcome::kNone;
    case Verdict::kStopped:
      break;
  }
  return Outcome::kStopped;
}

std::vector<std::size_t> ExecutionSolver::blockers_in_core() const {
  const std::unordered_set<NodeId> core(core_.begin(), core_.end());
  std::vector<std::size_t> blockers;
  for (std::size_t i = 0; i < trace().blockers.size(); ++i) {
    if (core.count(graph_.negation(trace().blockers[i].guard)) != 0) blockers.push_back(i);
  }
  return blockers;
}

/// Returns the blockers to which some execution comes, none if there is no such execution, or nothing if a
/// limit came first. A core can name blockers that no execution reaches, and one
/// could open such sides of a recursion for ever.
std::optional<std::vector<std::size_t>> ExecutionSolver::blockers_reached() {
  switch (check({unexplored()})) {
    case Verdict::kStopped:
      return std::nullopt;
    case Verdict::kUnsatisfiable:
      return std::vector<std::size_t>{};
    case Verdict::kSatisfiable:
      break;
  }
  Assignment model = assignment();
  std::vector<std::size_t> reached;
  for (std::size_t i = 0; i < trace().blockers.size(); ++i) {
    if (model.holds(trace().blockers[i].guard)) reached.push_back(i);
  }
  return reached;
}

bool ExecutionSolver::open(const std::vector<std::size_t>& blockers) {
  {
    const Stopwatch watch(times_.explore);
    if (!explorer_.open(blockers)) return false;
  }
  sync();
  return true;
}

bool ExecutionSolver::explore_fully(std::size_t most_passes) {
  explore();
  for (std::size_t pass = 0; !trace().blockers.empty(); ++pass) {
    if (pass == most_passes) return false;
    const auto reached = blockers_reached();
    if (!reached) throw Interrupted{};
    if (reached->empty()) return true;
    if (!open(*reached)) return false;
  }
  return true;
}

Assignment ExecutionSolver::assignment() {
  return Assignment(graph_, [this](std::size_t variable) { return Scalar::of(solver_->value(variable)); });
}

TracedChoices ExecutionSolver::met(Assignment& assignment) const {
  std::map<AddressId, NodeId> variables;
  TracedChoices met;
  for (const TraceChoice& choice : trace().choices) {
    if (!assignment.holds(choice.guard)) continue;
    const TypedScalar value(choice.domain.type(), *assignment.value(choice.variable));
    const bool added = met.values.emplace(choice.address, value).second;
    if (!added)
      throw InternalError("two choices of one execution share the address " +
                          addresses_.text(choice.address));
    variables.emplace(choice.address, choice.variable);
  }
  for (const auto& [address, variable] : variables) met.variables.push_back(variable);
  met.complete = std::ranges::none_of(
      trace().blockers, [&](const TraceBlocker& blocker) { return assignment.holds(blocker.guard); });
  return met;
}

Ending ending_of(ExecutionSolver::Outcome outcome) {
  switch (outcome) {
    case ExecutionSolver::Outcome::kFound:
      return Ending::kNone;
    case ExecutionSolver::Outcome::kNone:
      return Ending::kExhausted;
    case ExecutionSolver::Outcome::kUnexplored:
      return Ending::kUnexplored;
    case ExecutionSolver::Outcome::kWrapped:
      return Ending::kWrapped;
    case ExecutionSolver::Outcome::kStopped:
      break;
  }
  return Ending::kStopped;
}

}  // namespace solitaire
