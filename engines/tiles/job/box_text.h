#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Returns the parts of a text between separators; one part if there is none.
std::vector<std::string> split(const std::string& text, char separator);

/// Reads a box of sites: X,Y or X,Y:X,Y with its last site. Throws RequestError.
PinEntry parse_box(const std::string& text);

/// Reads a place of the endless plane: X,Y, whole numbers that may be negative. Throws RequestError.
std::array<std::int64_t, 2> parse_far_point(const std::string& text);

/// Reads a pin: a box, =, and tiles separated by |. Throws RequestError.
PinEntry parse_pin(const std::string& text);

}  // namespace solitaire::tiles
