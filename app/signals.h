#pragma once
#include <solitaire/stop.h>

namespace solitaire::app {

using namespace api;

/// Returns what ends the run: Ctrl-C, requests to terminate, and the Watchdog ask it to stop.
const StopSource& stop_source();

/// Lets Ctrl-C and a request to terminate end the work in good order; a second one ends it at once. Closed
/// pipes and files that may not grow become errors of the write that meets them.
void catch_signals();

}  // namespace solitaire::app
