#include <malloc.h>

#include "app/command_line.h"
#include "app/console.h"
#include "app/report.h"
#include "app/signals.h"

namespace solitaire::app {
namespace {

/// The command's thread does nearly all the work. This lets its memory grow in large steps, as that of a
/// first thread does by itself.
void let_memory_grow_in_large_steps() {
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TOP_PAD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
}

ExitStatus status_of(const Asked& asked, Watchdog& watchdog) {
  try {
    return asked.command(asked.options, watchdog);
  } catch (...) {
    const auto lock = watchdog.delivering();
    return watchdog.conclude(report_exception(asked.options));
  }
}

/// The first thread watches the limits, while another one with a large stack runs the command.
ExitStatus run(const Asked& asked) {
  return status_of(asked.options, [&] {
    Watchdog watchdog(asked.options);
    ExitStatus status = kError;
    const auto work = [&] {
      status = status_of(asked, watchdog);
      watchdog.end();
    };
    run_on_large_stack(work, [&] { watchdog.watch(); });
    return status;
  });
}

}  // namespace
}  // namespace solitaire::app

int main(int argc, char** argv) {
  using namespace solitaire::app;
  reserve_standard_streams();
  catch_signals();
  let_memory_grow_in_large_steps();
  const auto read = read_command_line(argc, argv);
  if (const ExitStatus* answered = std::get_if<ExitStatus>(&read)) return *answered;
  return run(std::get<Asked>(read));
}
