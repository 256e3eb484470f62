#pragma once
#include <filesystem>
#include <string>

#include "engines/tiles/model/style.h"

namespace solitaire::tiles {

/// Returns the weights of a style as JSON: for each shape the patches that are known, as names of tiles, and
/// the natural logarithm of what each multiplies a map's probability by; "others" is that of all other
/// patches. A weight is a list with a number for each zone.
std::string write_weights(const Style& style);

/// Adds the soft factors that a file of such JSON has. Throws FileError, also where it speaks of tiles or of
/// a number of zones that the style has not.
void read_weights(const std::filesystem::path& path, Style& style);

}  // namespace solitaire::tiles
