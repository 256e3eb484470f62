#pragma once
#include "app/options.h"
#include "app/watchdog.h"
#include "base/file_error.h"

namespace solitaire {

// The subcommands; each is a file of its own. They return the exit status, and throw Reported, FileError and
// SceneError. What they deliver and how they end is between them and the watchdog.

ExitStatus generate(const Options& options, Watchdog& watchdog);
ExitStatus solve(const Options& options, Watchdog& watchdog);
ExitStatus check(const Options& options, Watchdog& watchdog);
ExitStatus explain(const Options& options, Watchdog& watchdog);
ExitStatus count(const Options& options, Watchdog& watchdog);
ExitStatus trace_graph(const Options& options, Watchdog& watchdog);

}  // namespace solitaire
