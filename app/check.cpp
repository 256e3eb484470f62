#include <fmt/format.h>

#include "app/commands.h"
#include "app/session.h"

namespace solitaire {

/// Looks for mistakes without looking for solutions.
ExitStatus check(const Options& options) {
  const Session session(options);
  TracingEngine engine(session.program(), session.params(), session.tracing_options());
  try {
    if (!engine.check_mistakes()) {
      fmt::print(stderr, "{}: a limit came before all mistakes were looked for\n", options.script);
      return kLimit;
    }
  } catch (const ProgramError& error) {
    report(error, session.program().sources);
    return kError;
  }
  const Trace& trace = engine.pass().trace;
  if (!options.quiet) {
    fmt::print(stderr, "{}: no mistakes found; {} choices, {} conditions, {} placed things, {} nodes{}\n",
               options.script, trace.choices.size(), trace.asserts.size(), trace.placed.size(),
               engine.graph().size(),
               trace.blockers.empty()
                   ? ""
                   : fmt::format(", {} branch sides not looked into", trace.blockers.size()));
  }
  return kDelivered;
}

}  // namespace solitaire
