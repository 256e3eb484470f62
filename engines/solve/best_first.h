#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/stop_signal.h"
#include "engines/solve/executions/execution_solver.h"
#include "engines/solve/wishes/cost_cores.h"

namespace solitaire {

/// A solution that an engine is about to return.
struct Candidate {
  Solution solution;
  Valuation values;       // of its choices
  std::int64_t rank = 0;  // the value of the objective; less is better
  std::int64_t miss = 0;  // by how much it misses the asserts, if it does; less looks better
};

/// The result of a search for one solution.
struct Attempt {
  std::optional<Candidate> found;
  Ending ending = Ending::kNone;  // why nothing was found
};

/// Finds the best solution that is left, where the program has wishes or its asserts may be broken: by cores
/// where the cost is a sum of many, and by bisection between the best so far and what has been proved
/// impossible, or takes longer than the rest. Where solutions are all as good, the first one that is found is
/// the best. A near miss is then brought as near to the asserts as a bounded effort allows.
class BestFirst {
 public:
  /// What a solution may come to at most; without a number, to anything.
  struct Most {
    std::optional<std::int64_t> rank;
    std::optional<std::int64_t> miss;  // by which it misses the asserts, of near misses
    std::vector<NodeId> conditions;    // that hold in it, beside these
  };
  /// Looks for a solution within these.
  using Search = std::function<Attempt(const Most& most)>;
  using Told = std::function<void(const Solution&)>;
  using Clock = StopSignal::Clock;

  /// `stop` ends the search for one solution.
  BestFirst(ExecutionSolver& solver, const TracingOptions& options, StopSignal& stop);

  /// Makes the objective of the newest pass; to be called after each. Throws ProgramError if costs can grow
  /// too large.
  void meet_pass();
  /// Returns the rank of the solution with these values of the choices' variables.
  std::int64_t rank(Assignment& assignment) const { return assignment.value(objective_)->i; }
  /// As of a solution that is no near miss: 0.
  std::int64_t miss(Assignment& assignment) const { return relax_ ? assignment.value(miss_)->i : 0; }
  /// Returns the conditions that a solution comes to at most this, for the newest pass. Throws as
  /// meet_pass().
  std::vector<NodeId> at_most(const Most& most);

  /// Returns the best solution, by searches in a row; `told` is told of each one that is better than those
  /// before. Where a limit comes meanwhile, or TracingOptions::improvement_time is over since `start`, the
  /// best so far is returned.
  Attempt next(const Search& search, const Told& told, Clock::time_point start);

 private:
  /// What became of some questions: the solution is proved the best; they took long, and were given up; or
  /// there is nothing more to ask, mostly since a limit came.
  enum class Progress : std::uint8_t { kProved, kGivenUp, kEnded };

  Attempt as_good_as_last(const Search& search);
  void improve(Candidate& best, const Search& search, const Told& told);
  Progress raise_by_cores(Candidate& best, const Search& search, const Told& told);
  Progress bisect(Candidate& best, const Search& search, const Told& told);
  void tell(Candidate& best, const Told& told) const;
  void tell_bound(Candidate& best) const;
  void bring_near(Candidate& best, const Search& search);
  std::int64_t target(std::int64_t rank, std::int64_t given_up);
  bool needs_no_search() const;
  void limit_time(Clock::time_point start);

  ExecutionSolver& solver_;
  bool relax_;
  std::optional<double> improvement_time_;
  StopSignal& stop_;
  NodeId objective_ = kFalse;
  NodeId miss_ = kFalse;             // as of miss_of, where asserts may be broken
  std::optional<CostCores> cores_;   // of the objective, if it is a sum of many and all paths are explored
  std::int64_t proved_ = INT64_MIN;  // no solution that is left has a lower rank
  std::int64_t stride_ = 1;          // towards what is impossible, while it is not known where that is
  bool last_was_best_ = false;       // the last solution has the rank proved_
};

}  // namespace solitaire
