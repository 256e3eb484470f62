#pragma once
#include "kernel/score_program.h"
#include "kernel/slice.h"

namespace solitaire {

/// The shape of a density's logarithm as a function of one choice c, all others being what they are. Its
/// numbers are found by evaluating it at a few values of c, exactly, since the shape has so many of them.
enum class Form : std::uint8_t {
  kUnknown,
  kNormal,  // in the span of 1, c, c^2
  kGamma,   // in the span of 1, log c, c
  kBeta,    // in the span of 1, log c, log(1 - c)
};

/// The form in which the terms of a slice depend on its choice, and that the choice's own distribution has,
/// too, so that given all else the choice has a distribution of that family. Unknown where a branch depends
/// on the choice.
Form form_of(const ScoreProgram& program, const ScoreProgram::Choice& choice, const Slice& slice);

}  // namespace solitaire
