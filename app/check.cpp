#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/report.h"
#include "app/session.h"
#include "app/signals.h"

namespace solitaire {
namespace {

std::string summary(const TracingEngine& engine) {
  const Trace& trace = engine.pass().trace;
  const std::size_t closed = trace.blockers.size();
  return fmt::format("no mistakes found; {} choices, {} conditions, {} placed things, {} nodes{}",
                     trace.choices.size(), trace.asserts.size(), trace.placed.size(), engine.graph().size(),
                     closed == 0 ? "" : fmt::format(", {} branch sides not looked into", closed));
}

}  // namespace

/// Looks for mistakes without looking for solutions.
ExitStatus check(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  TracingEngine engine(session.program(), session.params(), session.tracing_options());
  const auto end_at_limit = [&] {
    const std::string why =
        stop_signal().stopped() ? limit_text(options) : "--explore random:N leaves paths out";
    tell(fmt::format("{}: {}; not all mistakes were looked for\n", options.script, why));
    return kLimit;
  };
  const Watchdog::AtLimit at_limit(watchdog, end_at_limit);
  try {
    bool complete = true;
    if (options.deep) {
      const std::vector<Diagnostic> program_errors = engine.find_mistakes(&complete);
      if (!program_errors.empty()) throw ProgramError(program_errors);
    } else {
      complete = engine.check_mistakes();
    }
    const auto lock = watchdog.delivering();
    if (!complete) return watchdog.conclude(end_at_limit());
    if (!options.quiet) tell(fmt::format("{}: {}\n", options.script, summary(engine)));
    return watchdog.conclude(kDelivered);
  } catch (const ProgramError& error) {
    const auto lock = watchdog.delivering();
    report(error, session.program().sources);
    return watchdog.conclude(kError);
  }
}

}  // namespace solitaire
