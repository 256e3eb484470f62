#include "app/commands.h"
#include "app/console.h"
#include "app/session.h"
#include "smt/z3/z3_solver.h"
#include "tracegraph/print.h"

namespace solitaire {
namespace {

/// All that has to hold in a solution of the explored paths.
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
                    const std::string& format) {
  if (format == "smt2") return to_smt2(graph, addresses, formula(graph, pass.trace));
  if (format == "dot") return trace_dot(graph, addresses, pass.trace);
  return trace_text(graph, addresses, pass.trace,
                    [&](const NodeName& name) { return to_text(pass.value, name); });
}

}  // namespace

ExitStatus trace_graph(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  const TracingOptions tracing = session.tracing_options();
  Graph graph;
  AddressTable addresses;
  OpenChoices choices;
  Explorer explorer(session.program(), session.params(), tracing.exploration, tracing.seed, tracing.limits,
                    choices, graph, addresses);
  explorer.start();
  const std::string text = text_of(explorer.pass(), graph, addresses, options.format);
  const auto lock = watchdog.delivering();
  print_result(text);
  return watchdog.conclude(kDelivered);
}

}  // namespace solitaire
