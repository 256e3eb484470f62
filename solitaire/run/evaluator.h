#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/stop_signal.h"
#include "solitaire/builtins/builtin.h"
#include "solitaire/names/program.h"
#include "solitaire/run/choices.h"
#include "solitaire/run/execution.h"
#include "solitaire/run/params.h"
#include "solitaire/value/value.h"

namespace solitaire {

/// What bounds an evaluation.
struct Limits {
  std::uint64_t max_steps = 10'000'000;  // statements, calls and elements of one execution
  std::uint32_t max_depth = 4'000;       // calls within each other
  /// In a symbolic pass: how far a path that only some executions take may go before it is cut. A cut is a
  /// blocker like a closed side.
  std::uint64_t fuel_steps = UINT64_MAX;
  std::uint32_t fuel_depth = UINT32_MAX;
  /// The evaluation ends with Interrupted once it says so. May be null.
  const StopSignal* stop = nullptr;
  /// Executions go on past failed asserts, and past choices that lie outside of their range: for exploring
  /// paths, explanations and near misses. Then asserts are taken apart: each conjunct of a condition is
  /// looked at by itself, and one that cannot be evaluated does not hold.
  bool keep_going = false;
};

/// Runs a program over and over. What one execution needs is kept for the next, so that a short one costs no
/// more than its steps.
class Executor {
 public:
  /// The program, the params' values and the table must outlive it. The observer, which may be null, is told
  /// of every branch that is taken.
  Executor(const Program& program, const ParamValues& params, AddressTable& addresses, const Limits& limits,
           Branches* observer = nullptr);
  ~Executor();

  /// Runs the program with every choice answered. The result has no texts (see add_texts()), and is valid
  /// until the next run; it may be moved from. Throws ProgramError for an error of the program, Interrupted.
  Execution& run(Choices& choices);

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

/// Runs the program once with every choice answered, and adds the texts. Throws as Executor::run.
Execution execute(const Program& program, const ParamValues& params, Choices& choices,
                  AddressTable& addresses, const Limits& limits, Branches* observer = nullptr);

/// Runs the program once with every choice answered, and traces it: each value that comes from choices
/// carries the node that says how. A branch goes where its condition leads, and the condition is kept. Throws
/// as Executor::run, and where an int can grow past 62 bits with other values of the choices.
TracedExecution trace_execution(const Program& program, const ParamValues& params, Choices& choices,
                                Graph& graph, AddressTable& addresses, const Limits& limits);

/// A call of place() in a symbolic pass: what it was called with, and where.
struct SymbolicPlacement {
  Placement placement;
  const CallExpr* site = nullptr;
  std::vector<Value> arguments;                            // as of a BuiltinCall
  std::vector<std::pair<std::string_view, Value>> extras;  // likewise
};

/// What one symbolic pass found.
struct SymbolicPass {
  Trace trace;
  Value value;                                // of the program, where some path came to its end; else Unset
  std::vector<SymbolicPlacement> placements;  // as numbered by Trace::placed
  std::vector<CallRecord> calls;              // on the way to placements
  double unit = 1;                            // metres in one unit of the program
  /// False if some of what an execution does shows only when it is run.
  bool complete = true;
  std::uint64_t steps = 0;  // evaluated in all
};

/// Runs the program over all executions at once, as far as `branches` opens it, to which paths come with
/// `levels` at the start; choices that `choices` does not answer become variables of the graph. Throws
/// Interrupted. Mistakes in the program become TraceProgramErrors.
SymbolicPass trace(const Program& program, const ParamValues& params, Choices& choices, Branches& branches,
                   std::uint32_t levels, Graph& graph, AddressTable& addresses, const Limits& limits);

}  // namespace solitaire
