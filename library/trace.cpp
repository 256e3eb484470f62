#include <solitaire/check.h>

#include "engines/solve/tracing.h"
#include "library/engine_options.h"
#include "library/program_state.h"
#include "library/translate.h"
#include "smt/write_smtlib.h"
#include "tracegraph/print.h"

namespace solitaire::api {
namespace {

std::string text_of(TracingEngine& engine, TraceFormat format) {
  const TracedProgram& traced = engine.traced();
  switch (format) {
    case TraceFormat::kText:
      break;
    case TraceFormat::kDot:
      return trace_dot(traced.graph(), traced.addresses(), traced.trace());
    case TraceFormat::kSmtlib: {
      const Formula formula = engine.formula_of_rest();
      return to_smt2(formula.graph, formula.addresses, formula.conditions);
    }
  }
  return trace_text(traced.graph(), traced.addresses(), traced.trace(),
                    [&](const NodeName& name) { return solitaire::to_text(traced.pass().value, name); });
}

}  // namespace

std::string trace(const Program& program, const Options& options, TraceFormat format) {
  const solitaire::Program& parsed = program.state().program;
  return translated(parsed.sources, [&] {
    TracingEngine engine(parsed, values_of_params(program.state(), program.settings()),
                         engine_options(program, options));
    engine.explore();
    return text_of(engine, format);
  });
}

}  // namespace solitaire::api
