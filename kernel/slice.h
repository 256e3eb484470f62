#pragma once
#include <span>
#include <vector>

#include "kernel/score_program.h"

namespace solitaire {

/// What changes of a ScoreProgram when one choice changes, or several do, up to the terms (section 3.5 of the
/// dissertation).
///
/// Its code reads the present cells and writes behind them: the choices' new values stand from cell `cells`
/// on, where `cells` is the number of the program's cells, and the results of the code follow. So the present
/// stays as it is until the change is accepted.
struct Slice {
  struct Changed {
    Cell present;
    Cell proposed;
  };

  std::vector<Instruction> code;  // makes the changes, and then the difference
  std::vector<Cell> required;     // proposed cells
  std::vector<Cell> assumed;      // proposed cells
  Cell difference = kNoCell;      // of the sum of the terms; nothing where no term changes
  std::vector<Changed> changes;   // the choices, then the results of the code, in this order
  std::vector<Changed> commits;   // of these, what has to be taken over where the change is accepted
  std::vector<Changed> terms;
};

/// The slices of all choices, in their order; an empty one of a choice without a cell. The last slice is that
/// of all floats together, whose new values stand one behind the other, in the order of the choices.
std::vector<Slice> slices_of(const ScoreProgram& program);

/// Finds the commits: of what changes, cells that something reads which does not change with them, and those
/// that are kept. Of the code's results, only these and what says how the density changes last.
void find_commits(const ScoreProgram& program, const std::vector<bool>& kept, std::vector<Slice>& slices);

/// Says which results of the slice's code last: those, and `more`, which are some of its cells, too.
void find_lasting(std::span<const Cell> more, Slice& slice);

}  // namespace solitaire
