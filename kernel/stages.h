#pragma once
#include <cstddef>
#include <vector>

#include "kernel/score_program.h"

namespace solitaire {

/// What of a ScoreProgram an execution has come to when it meets a choice: code up to `code_end`, which needs
/// no value of this choice or a later one, and what has to be true to have come there.
struct Stage {
  std::size_t code_end = 0;
  std::vector<Cell> assumed;  // that no earlier stage has
};

/// One stage for each choice, in their order, and a last one, which is the end of the execution.
std::vector<Stage> stages_of(const ScoreProgram& program);

}  // namespace solitaire
