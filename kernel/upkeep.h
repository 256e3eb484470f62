#pragma once
#include <vector>

#include "kernel/score_program.h"
#include "kernel/slice.h"

namespace solitaire {

/// How the cells of a program are kept up while choices change, of which the forms are known: such a change
/// needs no density, so that most cells are computed when something reads them, or never.
///
/// A cell is *kept*, so that it has its value at any time, where more codes read it than choices change it,
/// and where slices of choices without a form read it. All others have whatever they had when they were made
/// last.
struct Upkeep {
  std::vector<bool> kept;                         // of the cells
  std::vector<std::vector<Instruction>> forms;    // of the choices: makes their numbers
  std::vector<std::vector<Instruction>> changes;  // of the choices: to be run where the choice has changed
  /// The same where its slice has been accepted, which has written the cells of the program's own code.
  std::vector<std::vector<Instruction>> accepted;
  /// The same for the floats of the block: makes what their distribution follows from, and is to be run where
  /// they have changed.
  std::vector<Instruction> block_form, block_change;
  /// Makes those of the kept cells that the program's own code does not make.
  std::vector<Instruction> derived;
  std::vector<Instruction> outputs;
};

Upkeep upkeep_of(const ScoreProgram& program, const std::vector<Slice>& slices);

}  // namespace solitaire
