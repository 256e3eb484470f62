#pragma once
#include <vector>

#include "kernel/score_program.h"

namespace solitaire {

/// What changes of a ScoreProgram when one choice changes, up to the terms (section 3.5 of the dissertation).
///
/// Its code reads the present cells and writes behind them: result k goes to cell `cells + 1 + k`, and the
/// choice's new value stands in cell `cells`, where `cells` is the number of the program's. So the present
/// stays as it is until the change is accepted.
struct Slice {
  struct Changed {
    Cell present;
    Cell proposed;
  };

  std::vector<Instruction> code;
  std::vector<Changed> changes;  // the choice, then the results of the code, in this order
  std::vector<Changed> terms;
  std::vector<Cell> required;  // proposed cells
  std::vector<Cell> assumed;   // proposed cells
};

/// The slices of all choices, in their order; an empty one of a choice without a cell.
std::vector<Slice> slices_of(const ScoreProgram& program);

}  // namespace solitaire
