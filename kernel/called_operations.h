#pragma once
#include <cmath>

#include "base/floor_division.h"
#include "tracegraph/op.h"
#include "tracegraph/pair_table.h"
#include "tracegraph/scalar.h"
#include "tracegraph/special_functions.h"

// What both machines of the kernel call for operations that are no instruction of a processor.

namespace solitaire {

/// The quotient, rounded down, and the rest; of a division by 0, which a guard keeps from being looked at,
/// both are 0.
inline std::int64_t quotient_of(std::int64_t a, std::int64_t b) { return b == 0 ? 0 : floor_divide(a, b); }
inline std::int64_t rest_of(std::int64_t a, std::int64_t b) { return b == 0 ? 0 : floor_modulo(a, b); }

inline std::int64_t looked_up(std::int64_t a, std::int64_t b, const PairTable* pairs) {
  return pairs->allows(a, b) ? 1 : 0;
}

/// Returns false, and gives 0, where the int would be past 2^53.
inline bool floor_into(double value, Scalar* result) {
  constexpr double kLimit = 9007199254740992.0;
  const double floor = std::floor(value);
  const bool exact = std::abs(floor) <= kLimit;
  result->i = exact ? static_cast<std::int64_t>(floor) : 0;
  return exact;
}

/// Returns true if the operation is none of the processor.
inline bool is_called(Op op) {
  switch (op) {
    case Op::kDiv:
    case Op::kMod:
    case Op::kAllowed:
    case Op::kFloor:
    case Op::kExp:
    case Op::kLog:
    case Op::kPow:
    case Op::kLgamma:
    case Op::kSin:
    case Op::kCos:
    case Op::kAtan2:
      return true;
    default:
      return false;
  }
}

}  // namespace solitaire
