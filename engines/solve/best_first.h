#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/stop_signal.h"
#include "engines/solve/execution_solver.h"

namespace solitaire {

/// A solution that an engine is about to return.
struct Candidate {
  Solution solution;
  Valuation values;       // of its choices
  std::int64_t rank = 0;  // what the objective comes to: less is better
};

/// What a search for one solution came to.
struct Attempt {
  std::optional<Candidate> found;
  Ending ending = Ending::kNone;  // why nothing was found
};

/// Finds the best solution that is left, where the program has wishes or its asserts may be broken: by
/// bisection between the best so far and what has been proved impossible. Where solutions are all as good,
/// the first one that is found is the best.
class BestFirst {
 public:
  /// Looks for a solution of at most that rank, or for any.
  using Search = std::function<Attempt(std::optional<std::int64_t> most)>;
  using Told = std::function<void(const Solution&)>;
  using Clock = StopSignal::Clock;

  /// `stop` ends the search for one solution.
  BestFirst(ExecutionSolver& solver, const TracingOptions& options, StopSignal& stop);

  /// To be called after each pass: the objective is one of its trace. Throws ProgramError where costs can
  /// grow too large.
  void meet_pass();
  /// The rank of the solution with these values of the choices' variables.
  std::int64_t rank(Assignment& assignment) const { return assignment.value(objective_)->i; }
  /// Returns the condition that a solution has at most that rank, for the newest pass. Throws as meet_pass().
  NodeId at_most(std::int64_t rank);

  /// Returns the best solution, by searches in a row; `told` is told of each one that is better than those
  /// before. Where a limit comes meanwhile, or TracingOptions::improvement_time is over since `start`, the
  /// best so far is returned.
  Attempt next(const Search& search, const Told& told, Clock::time_point start);

 private:
  void improve(Candidate& best, const Search& search, const Told& told);
  std::int64_t target(std::int64_t rank);
  bool needs_no_search() const;
  void limit_time(Clock::time_point start);

  ExecutionSolver& solver_;
  bool relax_;
  std::optional<double> improvement_time_;
  StopSignal& stop_;
  NodeId objective_ = kFalse;
  std::int64_t proved_ = INT64_MIN;  // no solution that is left has a lower rank
  std::int64_t stride_ = 1;          // towards what is impossible, while it is not known where that is
  bool last_was_best_ = false;       // the last solution has the rank proved_
};

}  // namespace solitaire
