#pragma once
#include <string>

#include "solitaire/value/value.h"

namespace solitaire {

/// Returns whether someone who says so means the element with that short_text(): `oven` stands for "oven" as
/// well, and blanks in lists do not count.
bool means_element(const std::string& said, const std::string& element);

/// Returns the texts of the elements that a list has on any path, with commas between them, cut off where
/// they are many.
std::string elements_text(const Value& list);

}  // namespace solitaire
