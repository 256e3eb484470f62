#pragma once
#include "app/options.h"
#include "app/watchdog.h"

namespace solitaire::app {

// The subcommands; each is a file of its own. They return the exit status, and throw Error. What they deliver
// and how they end is between them and the watchdog.

ExitStatus generate_command(const Options& options, Watchdog& watchdog);
ExitStatus solve_command(const Options& options, Watchdog& watchdog);
ExitStatus check_command(const Options& options, Watchdog& watchdog);
ExitStatus explain_command(const Options& options, Watchdog& watchdog);
ExitStatus count_command(const Options& options, Watchdog& watchdog);
ExitStatus sample_command(const Options& options, Watchdog& watchdog);
ExitStatus trace_command(const Options& options, Watchdog& watchdog);
ExitStatus assets_command(const Options& options, Watchdog& watchdog);
ExitStatus tiles_command(const Options& options, Watchdog& watchdog);

}  // namespace solitaire::app
