#pragma once
#include <span>

#include "smt/z3/linear_contradiction.h"
#include "tracegraph/interval.h"

namespace solitaire {

/// Returns true if a point within the ranges was found at which all rows hold, but for what rounding does:
/// then there is no contradiction to look for. From the middle of the ranges it goes, row by row, to the
/// nearest point at which the row holds (the relaxation method of Agmon 1954, and of Motzkin and Schoenberg
/// 1954). If it gives up, nothing is known.
bool has_point(std::span<const LinearRow> rows, std::span<const Interval> ranges);

}  // namespace solitaire
