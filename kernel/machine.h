#pragma once
#include <span>

#include "kernel/score_program.h"

namespace solitaire {

/// Runs straight-line code over cells: what any faster machine has to give, bit for bit.
///
/// Code runs also what a condition keeps from being looked at. So an operation without a meaning is no error:
/// floats become NaN, a division of ints by zero gives 0. Returns false where an int cannot be made at all,
/// as of a float past 2^53, whether or not it is looked at.
bool run(std::span<const Instruction> code, Scalar* cells);

}  // namespace solitaire
