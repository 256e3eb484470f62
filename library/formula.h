#pragma once
#include <filesystem>

#include "engines/solution_stream.h"

namespace solitaire::api {

/// Writes the formula of the solutions that are left, in the format that the name's ending says.
void write_formula(const Formula& formula, const std::filesystem::path& path);

}  // namespace solitaire::api
