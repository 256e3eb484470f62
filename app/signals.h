#pragma once
#include "solitaire/run/evaluator.h"

namespace solitaire {

/// What ends the run: Ctrl-C and requests to terminate set it, and the Watchdog.
StopSignal& stop_signal();

/// Lets Ctrl-C and a request to terminate end the work in good order; a second one ends it at once. Closed
/// pipes and files that may not grow become errors of the write that meets them.
void catch_signals();

}  // namespace solitaire
