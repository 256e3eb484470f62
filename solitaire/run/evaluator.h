#pragma once
#include <memory>

#include "solitaire/names/program.h"
#include "solitaire/run/choices.h"
#include "solitaire/run/execution.h"
#include "solitaire/run/limits.h"
#include "solitaire/run/params.h"
#include "solitaire/run/symbolic_pass.h"

namespace solitaire {

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

/// Runs the program over all executions at once, as far as `branches` opens it, to which paths come with
/// `levels` at the start; choices that `choices` does not answer become variables of the graph. Throws
/// Interrupted. Mistakes in the program become TraceProgramErrors.
SymbolicPass trace(const Program& program, const ParamValues& params, Choices& choices, Branches& branches,
                   std::uint32_t levels, Graph& graph, AddressTable& addresses, const Limits& limits);

}  // namespace solitaire
