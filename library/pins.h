#pragma once
#include <solitaire/options.h>
#include <solitaire/program.h>
#include <vector>

#include "engines/solve/pins/pins.h"

namespace solitaire::api {

/// Returns the pins of the options, and those of their pin file. Throws Error: kUsage, kFile.
std::vector<solitaire::Pin> pins_of(const Program& program, const Options& options);

}  // namespace solitaire::api
