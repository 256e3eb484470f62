#include "kernel/machine.h"

#include <algorithm>
#include <cmath>

#include "kernel/called_operations.h"
#include "tracegraph/special_functions.h"

namespace solitaire {
namespace {

/// Where a guard that does not hold keeps a result from being looked at, it may be past 62 bits.
std::int64_t wrapping(std::uint64_t value) { return static_cast<std::int64_t>(value); }
std::uint64_t bits(std::int64_t value) { return static_cast<std::uint64_t>(value); }

}  // namespace

bool run(std::span<const Instruction> code, Scalar* cells) {
  bool made = true;
  for (const Instruction& step : code) {
    const Scalar a = cells[step.operands[0]];
    const Scalar b = cells[step.operands[1]];
    Scalar& r = cells[step.result];
    switch (step.op) {
      case Op::kConstBool:
      case Op::kConstInt:
      case Op::kConstFloat:
      case Op::kChoice:
      case Op::kChoiceFloat:
      case Op::kCount_:
        break;
      case Op::kNot:
        r.i = a.i == 0 ? 1 : 0;
        break;
      case Op::kAnd:
        r.i = a.i & b.i;
        break;
      case Op::kOr:
        r.i = a.i | b.i;
        break;
      case Op::kEqBool:
      case Op::kEqInt:
        r.i = a.i == b.i ? 1 : 0;
        break;
      case Op::kIteBool:
      case Op::kIteInt:
      case Op::kIteFloat:
        r = a.i != 0 ? b : cells[step.operands[2]];
        break;
      case Op::kAdd:
        r.i = wrapping(bits(a.i) + bits(b.i));
        break;
      case Op::kSub:
        r.i = wrapping(bits(a.i) - bits(b.i));
        break;
      case Op::kMul:
        r.i = wrapping(bits(a.i) * bits(b.i));
        break;
      case Op::kDiv:
        r.i = quotient_of(a.i, b.i);
        break;
      case Op::kMod:
        r.i = rest_of(a.i, b.i);
        break;
      case Op::kNeg:
        r.i = -a.i;
        break;
      case Op::kMin:
        r.i = std::min(a.i, b.i);
        break;
      case Op::kMax:
        r.i = std::max(a.i, b.i);
        break;
      case Op::kAbs:
        r.i = a.i < 0 ? -a.i : a.i;
        break;
      case Op::kLtInt:
        r.i = a.i < b.i ? 1 : 0;
        break;
      case Op::kLeInt:
        r.i = a.i <= b.i ? 1 : 0;
        break;
      case Op::kToFloat:
        r.f = static_cast<double>(a.i);
        break;
      case Op::kFloor:
        made = floor_into(a.f, &r) && made;
        break;
      case Op::kAddFloat:
        r.f = a.f + b.f;
        break;
      case Op::kSubFloat:
        r.f = a.f - b.f;
        break;
      case Op::kMulFloat:
        r.f = a.f * b.f;
        break;
      case Op::kDivFloat:
        r.f = a.f / b.f;
        break;
      case Op::kNegFloat:
        r.f = -a.f;
        break;
      case Op::kMinFloat:
        r.f = b.f < a.f ? b.f : a.f;
        break;
      case Op::kMaxFloat:
        r.f = a.f < b.f ? b.f : a.f;
        break;
      case Op::kSqrt:
        r.f = std::sqrt(a.f);
        break;
      case Op::kExp:
        r.f = std::exp(a.f);
        break;
      case Op::kLog:
        r.f = std::log(a.f);
        break;
      case Op::kPow:
        r.f = std::pow(a.f, b.f);
        break;
      case Op::kLgamma:
        r.f = log_gamma(a.f);
        break;
      case Op::kSin:
        r.f = std::sin(a.f);
        break;
      case Op::kCos:
        r.f = std::cos(a.f);
        break;
      case Op::kAtan2:
        r.f = std::atan2(a.f, b.f);
        break;
      case Op::kEqFloat:
        r.i = a.f == b.f ? 1 : 0;
        break;
      case Op::kLtFloat:
        r.i = a.f < b.f ? 1 : 0;
        break;
      case Op::kLeFloat:
        r.i = a.f <= b.f ? 1 : 0;
        break;
    }
  }
  return made;
}

}  // namespace solitaire
