#include <solitaire/check.h>

#include "engines/solve/executions/traced_program.h"
#include "library/engine_options.h"
#include "library/program_state.h"
#include "library/translate.h"

namespace solitaire::api {

Checked check(const Program& program, const Options& options, bool deep) {
  const solitaire::Program& parsed = program.state().program;
  TracedProgram traced(parsed, values_of_params(program.state(), program.settings()),
                       engine_options(program, options));
  Checked checked;
  checked.warnings = public_diagnostics(parsed.warnings, parsed.sources);
  return translated(parsed.sources, [&] {
    try {
      if (deep) {
        checked.errors = public_diagnostics(traced.find_errors(&checked.complete), parsed.sources);
      } else {
        checked.complete = traced.check();
      }
    } catch (const ProgramError& error) {
      checked.errors = public_diagnostics(error.diagnostics(), parsed.sources);
    }
    const Trace& trace = traced.trace();
    checked.choices = trace.choices.size();
    checked.conditions = trace.hard_terms.size();
    checked.placed = trace.placed.size();
    checked.nodes = traced.graph().size();
    checked.closed = trace.blockers.size();
    return checked;
  });
}

}  // namespace solitaire::api
