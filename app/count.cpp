#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/session.h"

namespace solitaire::app {
namespace {

CountOptions counting(const Session& session, const Options& options) {
  CountOptions count = options.counting;
  static_cast<solitaire::api::Options&>(count) = session.search;
  return count;
}

}  // namespace

/// Says how many solutions there are, or at a limit how many there are at least.
ExitStatus count_command(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  Progress progress(!options.quiet);
  Counter counter(session.program, counting(session, options));
  const auto show = [&](const Count& count) {
    progress.end();
    print_result((options.json ? to_json(count) : to_text(count)) + "\n");
  };
  const auto end_at_limit = [&] {
    show(counter.at_least());
    if (!options.quiet) tell(limit_text(options) + "\n");
    return kLimit;
  };
  const Watchdog::AtLimit at_limit(watchdog, end_at_limit);
  try {
    const auto counted = counter.run([&](const std::string& what) { progress.update(what); });
    const auto lock = watchdog.delivering();
    if (counted) {
      show(*counted);
      return watchdog.conclude(kDelivered);
    }
    progress.end();
    tell(fmt::format("{}: {}\n", options.script, kUnexploredText));
    return watchdog.conclude(kLimit);
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::kStopped) throw;
    const auto lock = watchdog.delivering();
    return watchdog.conclude(end_at_limit());
  }
}

}  // namespace solitaire::app
