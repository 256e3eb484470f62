#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace solitaire {

/// Returns the candidate that `name` was probably meant to be: one that differs by a few letters that are
/// changed, missing or swapped. Returns "" if there is none.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// Returns the candidate of which `name` is a misspelling: one letter is changed, missing or too many, or two
/// are swapped. Returns "" if there is none.
std::string misspelled_name(std::string_view name, const std::vector<std::string>& candidates);

/// Returns the `count` candidates that are most alike, the nearest first; fewer if there are fewer.
std::vector<std::string> nearest_names(std::string_view name, std::vector<std::string> candidates,
                                       std::size_t count);

}  // namespace solitaire
