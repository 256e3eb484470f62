#pragma once
#include "app/options.h"

namespace solitaire {

// The subcommands; each is a file of its own. They return the exit status, and throw Reported, FileError and
// SceneError.

ExitStatus generate(const Options& options);
ExitStatus solve(const Options& options);
ExitStatus check(const Options& options);
ExitStatus trace_graph(const Options& options);

}  // namespace solitaire
