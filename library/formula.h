#pragma once
#include <filesystem>

#include "engines/solve/tracing.h"

namespace solitaire::api {

/// Writes what holds in the solutions that the engine has left, in the format that the name's ending says.
void write_formula(TracingEngine& engine, const std::filesystem::path& path);

}  // namespace solitaire::api
