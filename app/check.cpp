#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/report.h"
#include "app/session.h"
#include "app/signals.h"

namespace solitaire::app {
namespace {

std::string summary(const Checked& checked) {
  if (checked.choices + checked.conditions + checked.placed + checked.closed == 0) {
    return "no mistakes found, but nothing was met that chooses, requires or places anything: functions are "
           "looked "
           "into where they are called";
  }
  return fmt::format(
      "no mistakes found; {} choices, {} conditions, {} placed things, {} nodes{}", checked.choices,
      checked.conditions, checked.placed, checked.nodes,
      checked.closed == 0 ? "" : fmt::format(", {} branch sides not looked into", checked.closed));
}

}  // namespace

/// Looks for errors without looking for solutions.
ExitStatus check_command(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  const auto end_at_limit = [&] {
    const std::string why =
        stop_source().token().stopped() ? limit_text(options) : "--explore random:N leaves paths out";
    tell(fmt::format("{}: {}; not all mistakes were looked for\n", options.script, why));
    return kLimit;
  };
  const Watchdog::AtLimit at_limit(watchdog, end_at_limit);
  const Checked checked = check(session.program, session.search, options.deep);
  const auto lock = watchdog.delivering();
  if (!options.quiet) {
    for (const Diagnostic& warning : checked.warnings) tell(warning.text);
  }
  if (!checked.errors.empty()) return watchdog.conclude(report(checked.errors));
  if (!checked.complete) return watchdog.conclude(end_at_limit());
  if (!options.quiet) tell(fmt::format("{}: {}\n", options.script, summary(checked)));
  return watchdog.conclude(kDelivered);
}

}  // namespace solitaire::app
