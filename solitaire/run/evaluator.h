#pragma once
#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/stop_signal.h"
#include "solitaire/builtins/builtin.h"
#include "solitaire/names/program.h"
#include "solitaire/run/choices.h"
#include "solitaire/run/execution.h"
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

/// Values that replace the params' defaults.
using ParamValues = std::map<std::string, Value>;

/// Runs the program once with every choice answered. Placements lack AnsweredChoices; whoever knows what an
/// object depends on adds them. Throws ProgramError for a mistake in the program, Interrupted.
Execution execute(const Program& program, const ParamValues& params, Choices& choices,
                  AddressTable& addresses, const Limits& limits, Branches* observer = nullptr);

/// A call of place() in a symbolic pass: what it was called with, and of the placement what never depends on
/// choices.
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
  double unit = 1;                            // as of an Execution
  /// Whether all that an execution does can be read off the pass; else some of it only shows when it is run.
  bool complete = true;
  std::uint64_t steps = 0;  // evaluated in all
};

/// Runs the program over all executions at once, as far as `branches` opens it, to which paths come with
/// `levels` at the start; choices that `choices` does not answer become variables of the graph. Throws
/// Interrupted. Mistakes in the program become TraceProgramErrors.
SymbolicPass trace(const Program& program, const ParamValues& params, Choices& choices, Branches& branches,
                   std::uint32_t levels, Graph& graph, AddressTable& addresses, const Limits& limits);

/// Reads a param's value from the text of a command line's --set: a constant of the language. A text that is
/// no constant is taken as a string where the default is one. Throws ProgramError whose spans refer to a
/// source that is added to `sources`.
ParamValues read_params(const Program& program,
                        const std::vector<std::pair<std::string, std::string>>& settings, SourceSet& sources);

}  // namespace solitaire
