#include <solitaire/check.h>

#include "engines/solve/requirements.h"
#include "library/engine_options.h"
#include "library/program_state.h"
#include "library/translate.h"
#include "smt/write_smtlib.h"
#include "tracegraph/print.h"

namespace solitaire::api {
namespace {

std::string text_of(const SymbolicPass& pass, Graph& graph, const AddressTable& addresses,
                    TraceFormat format) {
  switch (format) {
    case TraceFormat::kText:
      break;
    case TraceFormat::kDot:
      return trace_dot(graph, addresses, pass.trace);
    case TraceFormat::kSmtlib:
      return to_smt2(graph, addresses, requirements_of(graph, pass.trace));
  }
  return trace_text(graph, addresses, pass.trace,
                    [&](const NodeName& name) { return solitaire::to_text(pass.value, name); });
}

}  // namespace

std::string trace(const Program& program, const Options& options, TraceFormat format) {
  const TracingOptions tracing = engine_options(options);
  const solitaire::Program& parsed = program.state().program;
  return translated(parsed.sources, [&] {
    Graph graph;
    AddressTable addresses;
    OpenChoices choices;
    Explorer explorer(parsed, values_of_params(program.state(), program.settings()), tracing.exploration,
                      tracing.seed, tracing.limits, choices, graph, addresses);
    explorer.start();
    return text_of(explorer.pass(), graph, addresses, format);
  });
}

}  // namespace solitaire::api
