#pragma once
#include <vector>

#include "kernel/score_program.h"
#include "kernel/slice.h"

namespace solitaire {

/// Adds to the slice of some floats the code that makes the slopes of its difference along each of them, by
/// reverse accumulation (Griewank and Walther 2008): what each result counts in the difference follows from
/// what its users count. The code is of the same operations as all other code, so that the same machines run
/// it. Returns the cells of the slopes, in the order of the floats, which are the slice's first changes.
///
/// What a comparison selects counts as far as it is selected. A slope is NaN where there is none.
std::vector<Cell> add_gradient(const ScoreProgram& program, std::size_t floats, Slice& slice);

}  // namespace solitaire
