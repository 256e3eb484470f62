#pragma once
#include "app/options.h"
#include "base/file_error.h"

namespace solitaire {

/// What --pin, --forbid, --pin-file and --keep fix. Throws Reported after it told of what is wrong with them,
/// and FileError.
std::vector<Pin> read_pins(const Options& options);

}  // namespace solitaire
