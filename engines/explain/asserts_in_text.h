#pragma once
#include <vector>

#include "solitaire/names/program.h"

namespace solitaire {

/// Returns the conditions of the asserts that stand in the script itself, in the order of its text: of plain
/// calls of `assert`, which executions that come there always tell of.
std::vector<Span> asserts_in_text(const Program& program);

}  // namespace solitaire
