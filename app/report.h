#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/options.h"
#include "app/signals.h"

namespace solitaire::app {

/// Says why solutions cannot be counted or sampled uniformly where Ending::kUnexplored is the end.
inline constexpr const char* kUnexploredText =
    "not all paths could be explored: there are endlessly or very many, or --explore random:N leaves them "
    "out";

/// Returns which limit stopped the run: "the time limit came first".
std::string limit_text(const Options& options, StopReason reason = stop_source().reason());
/// Says that, where nothing more can be said.
ExitStatus report_limit(const Options& options, StopReason reason = stop_source().reason());

/// Shows errors of a program on standard error.
ExitStatus report(const std::vector<Diagnostic>& errors);
/// Reports the exception that is being handled: this is called in a catch block.
ExitStatus report_exception(const Options& options);

/// Does the work and returns its exit status; an exception that comes out of it is reported.
ExitStatus status_of(const Options& options, const std::function<ExitStatus()>& work);

}  // namespace solitaire::app
