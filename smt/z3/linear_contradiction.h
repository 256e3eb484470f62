#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tracegraph/interval.h"

namespace solitaire {

/// A number that a linear row has an unknown with.
struct LinearTerm {
  std::size_t unknown;
  std::int64_t factor;
};

/// Says that the sum of the terms is at most a number.
struct LinearRow {
  std::vector<LinearTerm> terms;
  std::int64_t most = 0;
};

/// Looks for multipliers, none of them negative, with which the rows add up to a row that no values within
/// the ranges of the unknowns fulfil (Farkas' lemma). By that lemma there are some exactly if the rows have
/// no solution in fractions. Returns one for each row, or nothing if there are none, they are too large, or
/// the search takes too long; the latter depends on the rows alone, and on no clock.
///
/// Z3's simplex method finds them with exact fractions. Throws std::bad_alloc.
std::optional<std::vector<std::int64_t>> find_contradiction(std::span<const LinearRow> rows,
                                                            std::span<const Interval> ranges);

}  // namespace solitaire
