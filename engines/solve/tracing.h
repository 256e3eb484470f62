#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engines/solution_stream.h"
#include "engines/solve/best_first.h"
#include "engines/solve/distances.h"
#include "engines/solve/enumeration.h"
#include "engines/solve/executions/exclusion.h"
#include "engines/solve/executions/traced_program.h"

namespace solitaire {

/// Solitaire as the dissertation has it (Algorithm 2): explore the program into a trace graph, compile the
/// graph to a formula, solve it under the constraint that the solution is a new one, and replay each
/// solution.
///
/// Where the program has wishes, or asserts may be broken, the best solution that is left comes first. Where
/// they are all as good and may come in any order, they are enumerated.
class TracingEngine : public SolutionStream,
                      public Improving,
                      public Exploring,
                      public WithFormula,
                      public Timed {
 public:
  /// `first` is the number of the first solution that it is to find; engines with others find others.
  TracingEngine(const Program& program, ParamValues params, const TracingOptions& options,
                std::uint64_t first = 0);

  /// Returns the next solution, see SolutionStream::next. If a limit comes while a solution is made better,
  /// it is returned as it is. Throws UnmatchedPin, too.
  std::optional<Solution> next() override;
  Ending ending() const override { return ending_; }
  void on_improvement(std::function<void(const Solution&)> told) override { told_ = std::move(told); }
  void explore() override { traced_.explore(); }
  std::size_t graph_size() const override { return traced_.graph().size(); }
  /// Returns all that holds in the solutions that are left. This is about the paths explored so far or, once
  /// it is proved that no solution is left, about all paths.
  Formula formula_of_rest() override;
  EngineTimes times() const override { return traced_.times(); }

  /// Keeps a solution that is known from before from being found.
  void exclude(const ChosenValues& choices) { remember(addressed(choices)); }
  /// Adds a solution from which the next ones are at least TracingOptions::min_distance away.
  void keep_away_from(const ChosenValues& choices) { distances_.keep_away_from(addressed(choices)); }
  /// Makes a known solution. Throws NotASolution and Interrupted.
  Solution run(const ChosenValues& choices) { return traced_.solution(traced_.execution(choices)); }
  /// Hears that the last solution is none of its own, since it looks like an earlier one. Where many are, it
  /// no longer goes through all choices, but asks for what looks different.
  void hear_of_alike();
  TracedProgram& traced() { return traced_; }
  const TracedProgram& traced() const { return traced_; }

 private:
  void meet_pass();
  bool can_enumerate();
  std::optional<Solution> next_enumerated();
  Enumeration::Outcome enumerate();
  void give_up_enumeration();
  std::optional<Solution> next_searched(StopSignal::Clock::time_point start);
  Attempt attempt(const BestFirst::Most& most);
  bool leaves_out_executions();
  ExecutionSolver::Outcome find(const BestFirst::Most& most);
  Candidate candidate(Assignment& assignment);
  void remember(Valuation values);
  void tell_of_enumerated();
  std::vector<NodeId> conditions();
  Valuation addressed(const ChosenValues& choices);

  TracingOptions options_;
  TracedProgram traced_;
  Exclusion exclusion_;
  Distances distances_;
  BestFirst best_first_;
  std::unique_ptr<Enumeration> enumeration_;  // while it is what finds solutions
  /// What it found. Nobody else has to know before it is given up, and in rows this takes little memory.
  std::vector<std::vector<Valuation::value_type>> enumerated_;
  bool may_enumerate_;
  std::size_t met_pass_ = 0;
  std::size_t asked_pass_ = 0;  // the last pass of which it is known whether it leaves executions out
  bool leaves_out_ = false;
  std::size_t alike_ = 0;
  std::uint64_t number_;  // of the next solution; its random values depend on it
  std::function<void(const Solution&)> told_;
  Ending ending_ = Ending::kNone;
};

}  // namespace solitaire
