#include "engines/solve/best_first.h"

#include <algorithm>
#include <utility>

#include "base/diagnostic.h"
#include "engines/solve/wishes/nearness.h"
#include "engines/solve/wishes/objective.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

NodeId checked_objective(Graph& graph, const Trace& trace, bool relax) {
  try {
    return objective_of(graph, trace, relax);
  } catch (const IntegerTooLarge&) {
    const auto first = std::ranges::find(trace.soft_terms, Term::Strength::kCost, &Term::strength);
    throw ProgramError(Diagnostic{first->span, "the cost of all wishes can grow past 62 bits", "", {}});
  }
}

/// A program whose asserts cannot be measured is left with near misses as they come.
NodeId checked_miss(Graph& graph, const Trace& trace) {
  try {
    return miss_of(graph, trace);
  } catch (const IntegerTooLarge&) {
    return graph.constant(std::int64_t{0});
  }
}

}  // namespace

BestFirst::BestFirst(ExecutionSolver& solver, const TracingOptions& options, StopSignal& stop)
    : solver_(solver), relax_(options.relax), improvement_time_(options.improvement_time), stop_(stop) {}

void BestFirst::meet_pass() {
  objective_ = checked_objective(solver_.graph(), solver_.trace(), relax_);
  if (relax_) miss_ = checked_miss(solver_.graph(), solver_.trace());
  cores_.reset();
  if (solver_.trace().blockers.empty() && solver_.exact())
    cores_ = CostCores::of(solver_.graph(), objective_);
}

std::vector<NodeId> BestFirst::at_most(const Most& most) {
  Graph& graph = solver_.graph();
  std::vector<NodeId> conditions = most.conditions;
  const auto add = [&](NodeId number, std::int64_t bound) {
    const NodeId good = graph.apply(Op::kLeInt, {number, graph.constant(bound)});
    conditions.push_back(graph.disjunction(good, solver_.unexplored()));
  };
  if (most.rank) add(checked_objective(graph, solver_.trace(), relax_), *most.rank);
  if (most.miss) add(checked_miss(graph, solver_.trace()), *most.miss);
  return conditions;
}

Attempt BestFirst::next(const Search& search, const Told& told, Clock::time_point start) {
  Attempt best;
  if (last_was_best_) best = as_good_as_last(search);
  if (!best.found && best.ending != Ending::kStopped) best = search({});
  if (!best.found) return best;
  limit_time(start);
  if (!needs_no_search()) {
    improve(*best.found, search, told);
  } else if (best.found->solution.quality) {
    best.found->solution.quality->proved = true;
    if (!relax_) best.found->solution.quality->least_cost = best.found->rank;
  }
  bring_near(*best.found, search);
  stop_.set_deadline(Clock::time_point::max());
  return best;
}

/// The cost is known to be constant only if no path is left unexplored.
bool BestFirst::needs_no_search() const {
  const Trace& trace = solver_.trace();
  return solver_.graph().node(objective_).is_constant() && (trace.blockers.empty() || !trace.has_costs());
}

void BestFirst::limit_time(Clock::time_point start) {
  if (!improvement_time_) return;
  const std::chrono::duration<double> time(std::min(*improvement_time_, 1e8));  // what the clock can count
  stop_.set_deadline(start + std::chrono::duration_cast<Clock::duration>(time));
}

/// Perhaps there is another one as good.
Attempt BestFirst::as_good_as_last(const Search& search) {
  if (cores_ && cores_->wants_all()) return search({{}, {}, cores_->wanted()});
  return search({proved_, {}, {}});
}

/// Makes the solution better until it is proved that no better one is left, or a limit comes. A question that
/// takes long is given up, and an easier one asked, for a solution that is better by less. Once all have been
/// given up, they get more time. So one that cannot be decided keeps nobody from what can be found.
void BestFirst::improve(Candidate& best, const Search& search, const Told& told) {
  if (solver_.trace().blockers.empty())
    proved_ = std::max(proved_, solver_.graph().node(objective_).interval.lo);
  stride_ = 1;
  Progress progress = Progress::kGivenUp;
  for (std::uint64_t effort = tuning::kEffortForBetter;
       progress == Progress::kGivenUp && effort <= tuning::kMostEffortForBetter;
       effort *= tuning::kEffortGrowth) {
    solver_.limit_effort(effort);
    progress = raise_by_cores(best, search, told);
    if (progress == Progress::kGivenUp) progress = bisect(best, search, told);
  }
  solver_.limit_effort(0);
  last_was_best_ = best.rank <= proved_;
  best.solution.quality->proved = last_was_best_;
  tell_bound(best);
}

/// Each core raises what is proved. So do costs of which none has to be paid, in the end.
BestFirst::Progress BestFirst::raise_by_cores(Candidate& best, const Search& search, const Told& told) {
  while (best.rank > proved_) {
    if (!cores_) return Progress::kGivenUp;
    tell(best, told);
    const bool wanted_all = cores_->wants_all();
    Attempt better = search({{}, {}, cores_->wanted()});
    if (!cores_) continue;  // a new pass has sides that are closed
    if (better.found) {
      if (better.found->rank < best.rank) best = std::move(*better.found);
      if (wanted_all) proved_ = cores_->least();
      cores_->want_more();
    } else if (better.ending == Ending::kExhausted && cores_->raise(solver_.core())) {
      proved_ = std::max(proved_, cores_->least());
    } else {
      return better.ending == Ending::kStopped && !stop_.stopped() ? Progress::kGivenUp : Progress::kEnded;
    }
  }
  return Progress::kProved;
}

/// Asks for a solution half way between the best one and what was proved impossible or given up.
BestFirst::Progress BestFirst::bisect(Candidate& best, const Search& search, const Told& told) {
  std::int64_t given_up = proved_;  // what would be better than this was given up
  while (best.rank > proved_) {
    tell(best, told);
    given_up = std::max(given_up, proved_);
    if (given_up >= best.rank) return Progress::kGivenUp;
    const std::int64_t most = target(best.rank, given_up);
    Attempt better = search({most, {}, {}});
    if (better.found) {
      best = std::move(*better.found);
    } else if (better.ending == Ending::kExhausted) {
      proved_ = most + 1;
    } else if (better.ending == Ending::kStopped && !stop_.stopped()) {
      given_up = most + 1;
    } else {
      return Progress::kEnded;  // the next search will find whether it has to end
    }
  }
  return Progress::kProved;
}

void BestFirst::tell(Candidate& best, const Told& told) const {
  tell_bound(best);
  if (told) told(best.solution);
}

/// Of near misses the rank is more than the cost.
void BestFirst::tell_bound(Candidate& best) const {
  if (!relax_ && proved_ > -kIntLimit) best.solution.quality->least_cost = std::min(proved_, best.rank);
}

/// Makes a near miss one that breaks fewer conjuncts and comes nearer in comparisons, by bisection. A
/// question that takes long is given up: how near is near enough is nothing to prove.
void BestFirst::bring_near(Candidate& best, const Search& search) {
  if (!relax_ || best.miss == 0) return;
  const bool proved = best.solution.quality->proved;
  solver_.limit_effort(tuning::kEffortForNearness);
  for (std::int64_t impossible = -1; best.miss - impossible > 1 && !stop_.stopped();) {
    const std::int64_t most = impossible + (best.miss - impossible) / 2;
    Attempt nearer = search({best.rank, most, {}});
    if (nearer.found && nearer.found->miss <= most) {
      best = std::move(*nearer.found);
    } else {
      impossible = most;
    }
  }
  solver_.limit_effort(0);
  best.solution.quality->proved = proved;
}

/// A rank below this one: half way to what is impossible or was given up, or by strides that grow.
std::int64_t BestFirst::target(std::int64_t rank, std::int64_t given_up) {
  if (given_up != INT64_MIN) return given_up + (rank - 1 - given_up) / 2;
  const std::int64_t target = std::max(rank - stride_, -kIntLimit);
  if (stride_ < kIntLimit / 4) stride_ *= 2;
  return target;
}

}  // namespace solitaire
