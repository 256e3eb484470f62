#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "engines/solve/executions/execution_solver.h"
#include "engines/solve/executions/replay.h"

namespace solitaire {

/// Finds out which errors of the program executions can come to. An error that some execution makes is the
/// program's, whether or not other executions are solutions.
class ProgramErrors {
 public:
  ProgramErrors(ExecutionSolver& solver, Replayer& replayer) : solver_(solver), replayer_(replayer) {}

  /// Throws ProgramError if an execution on explored paths comes to an error. Runs a further pass where an
  /// execution would be refused for the steps of others.
  void report_reachable();
  /// Returns true if executions on explored paths come to what the pass cannot express, after which nothing
  /// is known of them.
  bool leave_out_executions();
  /// Looks into every side that an execution can come to. Returns each error with the choices that lead
  /// there, which have been run; `complete` becomes true if no limit came first.
  std::vector<Diagnostic> find_all(bool* complete);

 private:
  std::optional<Diagnostic> diagnose(const TraceProgramError& error, const Valuation& values);
  std::string leading_choices(const TraceProgramError& error, const Valuation& values) const;

  ExecutionSolver& solver_;
  Replayer& replayer_;
};

}  // namespace solitaire
