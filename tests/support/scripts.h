#pragma once
#include <filesystem>
#include <random>
#include <string>
#include <vector>

namespace solitaire {

/// Returns the paths of all .sol files of the project, in a fixed order.
std::vector<std::filesystem::path> project_scripts();
/// Returns their texts.
std::vector<std::string> all_scripts();

/// Returns a token of the language, or a piece of one, or bytes that are none.
const char* random_piece(std::mt19937_64& random);

/// Damages a text by one to four cuts, doublings, swaps and insertions, also of parts of other texts.
std::string mutated(std::string text, const std::vector<std::string>& others, std::mt19937_64& random);

}  // namespace solitaire
