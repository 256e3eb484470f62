#pragma once
#include <cstdint>
#include <optional>

#include "base/diagnostic.h"
#include "engines/solution.h"
#include "engines/solve/executions/execution_solver.h"

namespace solitaire {

/// Makes an execution of the values that a solver or a file has for the choices: by running the program with
/// them, or by reading off the trace what it does with them.
class Replayer {
 public:
  /// `taken` solutions were made by replayers before this one.
  Replayer(const Program& program, const ParamValues& params, const TracingOptions& options,
           ExecutionSolver& solver, std::uint64_t taken);

  /// Makes the execution with these values of the variables, which fulfil all requirements. Throws
  /// InternalError if the program does not accept them, and Interrupted.
  Execution execution(Assignment& assignment);
  /// Makes the execution with the choices of a solution that was written down. Throws NotASolution if they
  /// are not those of one, and Interrupted.
  Execution execution(const ChosenValues& choices);
  /// Runs the program with these values. Throws InternalError if it meets a choice that has none,
  /// ProgramError, and Interrupted.
  Execution run(const Valuation& values);
  /// Runs the program with these values up to the first choice that has none. Returns the error to which the
  /// execution comes until then, if there is one. Throws Interrupted.
  std::optional<Diagnostic> error_of(const Valuation& values);

 private:
  std::optional<Execution> read(Assignment& assignment);
  std::optional<Execution> read(const Valuation& values);
  void compare_with_run(const Execution& read, const Valuation& values);
  Execution run_written(const Valuation& values);
  Execution run(Choices& choices);

  const Program& program_;
  ExecutionSolver& solver_;
  Executor executor_;
  bool may_read_;
  bool with_scene_;
  std::uint64_t taken_;  // solutions, by this replayer and those before it
};

}  // namespace solitaire
