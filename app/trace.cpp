#include "app/commands.h"
#include "app/console.h"
#include "app/session.h"

namespace solitaire::app {

/// Prints the trace graph.
ExitStatus trace_command(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  const std::string text = trace(session.program, session.search, options.format);
  const auto lock = watchdog.delivering();
  print_result(text);
  return watchdog.conclude(kDelivered);
}

}  // namespace solitaire::app
