#pragma once
#include <functional>
#include <string>

#include "app/options.h"

namespace solitaire {

/// Thrown where everything was said already; the exit status is all that is left.
struct Reported {
  ExitStatus status;
};

/// Shows the mistakes on standard error.
void report(const ProgramError& error, const SourceSet& sources);

/// Why solutions cannot be counted or sampled uniformly where Ending::kUnexplored is the end.
inline constexpr const char* kUnexploredText =
    "not all paths could be explored: there are endlessly or very many, or --explore random:N leaves them "
    "out";

/// Which limit stopped the run: "the time limit came first".
std::string limit_text(const Options& options);
/// Says that, where nothing more can be said.
ExitStatus report_limit(const Options& options);

/// The exit status of the work; where an exception comes out of it, that is reported.
ExitStatus status_of(const Options& options, const std::function<ExitStatus()>& work);

}  // namespace solitaire
