#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "smt/sat/linear_form.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// That a == b + shift.
struct ShiftedEquality {
  NodeId a, b;
  std::int64_t shift = 0;
};

/// Returns equalities that all hold exactly where a linear form is 0, as two numbers are equal exactly where
/// all their digits are. So y * w + x, which people write for the square at x and y, is another square where
/// x or y is another one, and the sum itself needs no values. Nothing for a form that does not fall apart
/// into two digits or more, each of which is the difference of two ints.
std::optional<std::vector<ShiftedEquality>> equal_digits(const Graph& graph, LinearForm form);

}  // namespace solitaire
