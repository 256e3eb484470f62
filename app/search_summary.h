#pragma once
#include <string>

#include "app/options.h"

namespace solitaire::app {

/// Returns what a search says at its end: how many solutions came in how many seconds, and why there is no
/// other. `reason` says why it stopped, if it did.
std::string summary_text(const Summary& summary, Ending ending, double seconds, StopReason reason,
                         const Options& options);

/// Returns the exit status of a search that ended so.
ExitStatus status_of(const Summary& summary, Ending ending, const Options& options);

}  // namespace solitaire::app
