#include <fmt/format.h>

#include "app/commands.h"
#include "app/session.h"
#include "smt/z3_solver.h"
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
  for (const TraceMistake& mistake : trace.mistakes) conditions.push_back(graph.negation(mistake.guard));
  return conditions;
}

}  // namespace

ExitStatus trace_graph(const Options& options) {
  const Session session(options);
  const TracingOptions tracing = session.tracing_options();
  Graph graph;
  AddressTable addresses;
  OpenChoices choices;
  Explorer explorer(session.program(), session.params(), tracing.exploration, tracing.seed, tracing.limits,
                    choices, graph, addresses);
  try {
    explorer.start();
  } catch (const Interrupted&) {
    fmt::print(stderr, "a limit came before the program was explored\n");
    return kLimit;
  }
  const SymbolicPass& pass = explorer.pass();
  if (options.format == "smt2") {
    fmt::print("{}", to_smt2(graph, addresses, formula(graph, pass.trace)));
  } else if (options.format == "dot") {
    fmt::print("{}", trace_dot(graph, addresses, pass.trace));
  } else {
    fmt::print("{}", trace_text(graph, addresses, pass.trace,
                                [&](const NodeName& name) { return to_text(pass.value, name); }));
  }
  if (std::fflush(stdout) != 0) throw FileError("standard output", "cannot be written to");
  return kDelivered;
}

}  // namespace solitaire
