#pragma once
#include <cstdint>
#include <vector>

#include "engines/solution.h"
#include "engines/solution_stream.h"
#include "engines/solve/executions/execution_solver.h"
#include "engines/solve/executions/program_errors.h"
#include "engines/solve/executions/provenance.h"
#include "engines/solve/executions/replay.h"
#include "engines/solve/pins/pins.h"

namespace solitaire {

/// A program with its trace graph, the solver that knows its formula, and what makes solutions of the
/// solver's values: what every engine that solves stands on.
class TracedProgram {
 public:
  /// `first` is the number of the first solution that is wanted; others with the same seed draw on other
  /// random numbers.
  TracedProgram(const Program& program, ParamValues params, const TracingOptions& options,
                std::uint64_t first = 0);
  TracedProgram(const TracedProgram&) = delete;
  TracedProgram& operator=(const TracedProgram&) = delete;

  /// Runs the first passes, as far as the policy goes by itself. Throws Interrupted.
  void explore() { solver_.explore(); }
  /// Does what has to be done after each pass before its executions are solutions: tells the solver of the
  /// pins, and asks it for errors of the program. Nothing happens if that was done for this pass before.
  /// Throws ProgramError, UnmatchedPin, and Interrupted.
  void meet_pass();
  /// Explores every path that an execution can take. Returns false if the policy does not allow that, or if
  /// it takes very many passes, as where there are endlessly many paths. Throws as meet_pass().
  bool explore_fully();
  /// Looks for errors of the program in what is explored by then. Returns false if a limit came first.
  /// Throws ProgramError and UnmatchedPin.
  bool check();
  /// Returns true if nothing is known of some executions on explored paths, see ProgramErrors.
  bool leaves_out_executions() { return errors_.leave_out_executions(); }
  /// Finds all errors that executions can come to, see ProgramErrors::find_all.
  std::vector<Diagnostic> find_errors(bool* complete) { return errors_.find_all(complete); }

  /// Returns all that holds in every solution on any path; with `closed`, in those on explored paths.
  std::vector<NodeId> requirements(bool closed);

  /// Makes the execution of a solver's values, or of a solution that was written down. See Replayer.
  Execution execution(Assignment& assignment) { return replayer_.execution(assignment); }
  Execution execution(const ChosenValues& choices);
  /// Runs the program with these values, which are those of all choices that it meets.
  Execution execution(const Valuation& values) { return replayer_.run(values); }
  /// Makes a solution of an execution: with how good it is, and what depends on which choices.
  Solution solution(Execution execution);

  ExecutionSolver& solver() { return solver_; }
  const ExecutionSolver& solver() const { return solver_; }
  Graph& graph() { return graph_; }
  const Graph& graph() const { return graph_; }
  AddressTable& addresses() { return addresses_; }
  const AddressTable& addresses() const { return addresses_; }
  const SymbolicPass& pass() const { return solver_.pass(); }
  const Trace& trace() const { return solver_.trace(); }
  const EngineTimes& times() const { return solver_.times(); }
  /// The signal that ends the work. It is part of TracingOptions::limits.stop, and may be given a deadline of
  /// its own.
  StopSignal& stop() { return stop_; }

 private:
  const Program& program_;
  ParamValues params_;
  TracingOptions options_;
  Graph graph_;
  AddressTable addresses_;
  StopSignal stop_;
  Pins pins_;
  PinnedChoices choices_;
  ExecutionSolver solver_;
  Replayer replayer_;
  ProgramErrors errors_;
  Provenance provenance_;
  std::size_t met_pass_ = 0;
};

}  // namespace solitaire
