#pragma once
#include <solitaire/options.h>
#include <solitaire/program.h>

#include "engines/solve/executions/options.h"

namespace solitaire::api {

// Translate the public options to those of engines. Both throw Error: kUsage, and kFile for a pin file.

TracingOptions engine_options(const Program& program, const Options& options);
TracingOptions engine_options(const Program& program, const SearchOptions& options);

}  // namespace solitaire::api
