#pragma once
#include <filesystem>
#include <string>

#include "engines/solve/tracing.h"

namespace solitaire {

/// What is wrong with the name of a file for a formula; empty if nothing is. CLI11 asks.
std::string check_formula_name(const std::string& name);

/// Writes what holds in the solutions that the engine has left, in the format that the name's ending says.
void write_formula(TracingEngine& engine, const std::filesystem::path& path);

}  // namespace solitaire
