#include "kernel/machine.h"

#include <algorithm>
#include <cmath>

#include "kernel/called_operations.h"
#include "tracegraph/special_functions.h"

namespace solitaire {
namespace {

/// Where a guard that does not hold keeps a result from being looked at, it may be past 62 bits.
Scalar wrapping(std::uint64_t value) { return Scalar::of(static_cast<std::int64_t>(value)); }
std::uint64_t bits(Scalar value) { return static_cast<std::uint64_t>(value.i); }

Scalar boolean(bool value) { return Scalar::of(value); }
Scalar integer(std::int64_t value) { return Scalar::of(value); }
Scalar real(double value) { return Scalar::of(value); }

}  // namespace

// What an operation makes of its operands a, b and c: a line for each.
// clang-format off
#define SOLITAIRE_MAKES(operation, result) case Op::operation: r = result; break;

bool run(std::span<const Instruction> code, Scalar* cells) {
  bool made = true;
  for (const Instruction& step : code) {
    const Scalar a = cells[step.operands[0]], b = cells[step.operands[1]];
    Scalar& r = cells[step.result];
    switch (step.op) {
      SOLITAIRE_MAKES(kNot, boolean(a.i == 0))
      SOLITAIRE_MAKES(kAnd, integer(a.i & b.i))
      SOLITAIRE_MAKES(kOr, integer(a.i | b.i))
      SOLITAIRE_MAKES(kEqBool, boolean(a.i == b.i))
      SOLITAIRE_MAKES(kEqInt, boolean(a.i == b.i))
      SOLITAIRE_MAKES(kLtInt, boolean(a.i < b.i))
      SOLITAIRE_MAKES(kLeInt, boolean(a.i <= b.i))
      SOLITAIRE_MAKES(kAllowed, integer(looked_up(a.i, b.i, cells[step.operands[2]].table)))
      SOLITAIRE_MAKES(kEqFloat, boolean(a.f == b.f))
      SOLITAIRE_MAKES(kLtFloat, boolean(a.f < b.f))
      SOLITAIRE_MAKES(kLeFloat, boolean(a.f <= b.f))
      SOLITAIRE_MAKES(kIteBool, a.i != 0 ? b : cells[step.operands[2]])
      SOLITAIRE_MAKES(kIteInt, a.i != 0 ? b : cells[step.operands[2]])
      SOLITAIRE_MAKES(kIteFloat, a.i != 0 ? b : cells[step.operands[2]])
      SOLITAIRE_MAKES(kAdd, wrapping(bits(a) + bits(b)))
      SOLITAIRE_MAKES(kSub, wrapping(bits(a) - bits(b)))
      SOLITAIRE_MAKES(kMul, wrapping(bits(a) * bits(b)))
      SOLITAIRE_MAKES(kDiv, integer(quotient_of(a.i, b.i)))
      SOLITAIRE_MAKES(kMod, integer(rest_of(a.i, b.i)))
      SOLITAIRE_MAKES(kNeg, wrapping(0 - bits(a)))
      SOLITAIRE_MAKES(kMin, integer(std::min(a.i, b.i)))
      SOLITAIRE_MAKES(kMax, integer(std::max(a.i, b.i)))
      SOLITAIRE_MAKES(kAbs, a.i < 0 ? wrapping(0 - bits(a)) : a)
      SOLITAIRE_MAKES(kToFloat, real(static_cast<double>(a.i)))
      SOLITAIRE_MAKES(kAddFloat, real(a.f + b.f))
      SOLITAIRE_MAKES(kSubFloat, real(a.f - b.f))
      SOLITAIRE_MAKES(kMulFloat, real(a.f * b.f))
      SOLITAIRE_MAKES(kDivFloat, real(a.f / b.f))
      SOLITAIRE_MAKES(kNegFloat, real(-a.f))
      SOLITAIRE_MAKES(kMinFloat, b.f < a.f ? b : a)
      SOLITAIRE_MAKES(kMaxFloat, a.f < b.f ? b : a)
      SOLITAIRE_MAKES(kSqrt, real(std::sqrt(a.f)))
      SOLITAIRE_MAKES(kExp, real(std::exp(a.f)))
      SOLITAIRE_MAKES(kLog, real(std::log(a.f)))
      SOLITAIRE_MAKES(kPow, real(std::pow(a.f, b.f)))
      SOLITAIRE_MAKES(kLgamma, real(log_gamma(a.f)))
      SOLITAIRE_MAKES(kSin, real(std::sin(a.f)))
      SOLITAIRE_MAKES(kCos, real(std::cos(a.f)))
      SOLITAIRE_MAKES(kAtan2, real(std::atan2(a.f, b.f)))
      case Op::kFloor: made = floor_into(a.f, &r) && made; break;
      case Op::kConstBool: case Op::kConstInt: case Op::kConstFloat: case Op::kConstTable: break;
      case Op::kChoice: case Op::kChoiceFloat: case Op::kCount_: break;
    }
  }
  return made;
}
// clang-format on

#undef SOLITAIRE_MAKES

}  // namespace solitaire
