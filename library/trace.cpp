#include <solitaire/check.h>

#include "library/engine_options.h"
#include "library/program_state.h"
#include "library/translate.h"
#include "smt/write_smtlib.h"
#include "tracegraph/print.h"

namespace solitaire::api {
namespace {

/// Returns all that has to hold in a solution of the explored paths.
std::vector<NodeId> formula(Graph& graph, const Trace& trace) {
  std::vector<NodeId> conditions;
  for (const TraceAssert& required : trace.asserts) {
    conditions.push_back(graph.implication(required.guard, required.condition));
  }
  for (const TraceBlocker& blocker : trace.blockers) conditions.push_back(graph.negation(blocker.guard));
  for (const TraceProgramError& mistake : trace.program_errors)
    conditions.push_back(graph.negation(mistake.guard));
  return conditions;
}

std::string text_of(const SymbolicPass& pass, Graph& graph, const AddressTable& addresses,
                    TraceFormat format) {
  switch (format) {
    case TraceFormat::kText:
      break;
    case TraceFormat::kDot:
      return trace_dot(graph, addresses, pass.trace);
    case TraceFormat::kSmtlib:
      return to_smt2(graph, addresses, formula(graph, pass.trace));
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
