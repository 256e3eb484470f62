#pragma once
#include <optional>

#include "solitaire/syntax/syntax.h"
#include "tracegraph/op.h"

namespace solitaire {

/// What a binary operator means on numbers: an operation of the table, its operands swapped or its result
/// negated.
struct BinaryMeaning {
  const char* symbol;
  Op on_ints;
  std::optional<Op> on_floats;
  bool swapped = false;
  bool negated = false;
};

/// Of an operator up to the comparisons; a..b has none.
const BinaryMeaning& meaning_of(BinaryOp op);

}  // namespace solitaire
