#include "tracegraph/op.h"

#include <cmath>

namespace solitaire {
namespace {

using Result = std::optional<Scalar>;

Result exact(std::int64_t value) {
  if (!is_exact(value)) return std::nullopt;
  return Scalar::of(value);
}

Result multiply_exactly(std::int64_t a, std::int64_t b) {
  std::int64_t product = 0;
  if (__builtin_mul_overflow(a, b, &product)) return std::nullopt;
  return exact(product);
}

Result floor_divide(std::int64_t a, std::int64_t b) {
  if (b == 0) return std::nullopt;
  return Scalar::of(a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0));
}

Result floor_modulo(std::int64_t a, std::int64_t b) {
  if (b == 0) return std::nullopt;
  const std::int64_t remainder = a % b;
  return Scalar::of((remainder != 0 && (a < 0) != (b < 0)) ? remainder + b : remainder);
}

/// Past 2^53 a double no longer tells neighbouring ints apart.
constexpr double kFloorLimit = 9007199254740992.0;

Result floor_exactly(double value) {
  const double floor = std::floor(value);
  if (!(std::abs(floor) <= kFloorLimit)) return std::nullopt;
  return Scalar::of(static_cast<std::int64_t>(floor));
}

Result divide_float(double a, double b) {
  if (b == 0) return std::nullopt;
  return Scalar::of(a / b);
}

Result square_root(double a) {
  if (a < 0) return std::nullopt;
  return Scalar::of(std::sqrt(a));
}

using S = const Scalar*;
using I = const Interval*;
constexpr Type kB = Type::kBool;
constexpr Type kI = Type::kInt;
constexpr Type kF = Type::kFloat;

// clang-format off
constexpr std::array<Operation, kOpCount> kTable = {{
    {Op::kConstBool, "bool", "", 0, kB, kB, nullptr, nullptr},
    {Op::kConstInt, "int", "", 0, kI, kI, nullptr, nullptr},
    {Op::kConstFloat, "float", "", 0, kF, kF, nullptr, nullptr},
    {Op::kChoice, "range", "", 0, kI, kI, nullptr, nullptr},

    {Op::kNot, "not", "not", 1, kB, kB, [](S a) -> Result { return Scalar::of(a[0].i == 0); }, nullptr},
    {Op::kAnd, "and", "and", 2, kB, kB, [](S a) -> Result { return Scalar::of(a[0].i != 0 && a[1].i != 0); }, nullptr},
    {Op::kOr, "or", "or", 2, kB, kB, [](S a) -> Result { return Scalar::of(a[0].i != 0 || a[1].i != 0); }, nullptr},
    {Op::kEqBool, "iff", "==", 2, kB, kB, [](S a) -> Result { return Scalar::of(a[0].i == a[1].i); }, nullptr},
    {Op::kIteBool, "if", "", 3, kB, kB, [](S a) -> Result { return a[0].i != 0 ? a[1] : a[2]; }, nullptr},

    {Op::kAdd, "add", "+", 2, kI, kI, [](S a) { return exact(a[0].i + a[1].i); }, [](I a) { return add(a[0], a[1]); }},
    {Op::kSub, "sub", "-", 2, kI, kI, [](S a) { return exact(a[0].i - a[1].i); }, [](I a) { return subtract(a[0], a[1]); }},
    {Op::kMul, "mul", "*", 2, kI, kI, [](S a) { return multiply_exactly(a[0].i, a[1].i); }, [](I a) { return multiply(a[0], a[1]); }},
    {Op::kDiv, "div", "/", 2, kI, kI, [](S a) { return floor_divide(a[0].i, a[1].i); }, [](I a) { return divide(a[0], a[1]); }},
    {Op::kMod, "mod", "%", 2, kI, kI, [](S a) { return floor_modulo(a[0].i, a[1].i); }, [](I a) { return modulo(a[0], a[1]); }},
    {Op::kNeg, "neg", "-", 1, kI, kI, [](S a) -> Result { return Scalar::of(-a[0].i); }, [](I a) { return negate(a[0]); }},
    {Op::kMin, "min", "", 2, kI, kI, [](S a) -> Result { return Scalar::of(std::min(a[0].i, a[1].i)); }, [](I a) { return minimum(a[0], a[1]); }},
    {Op::kMax, "max", "", 2, kI, kI, [](S a) -> Result { return Scalar::of(std::max(a[0].i, a[1].i)); }, [](I a) { return maximum(a[0], a[1]); }},
    {Op::kAbs, "abs", "", 1, kI, kI, [](S a) -> Result { return Scalar::of(std::abs(a[0].i)); }, [](I a) { return absolute(a[0]); }},
    {Op::kIteInt, "if", "", 3, kI, kI, [](S a) -> Result { return a[0].i != 0 ? a[1] : a[2]; }, [](I a) { return hull(a[1], a[2]); }},

    {Op::kEqInt, "eq", "==", 2, kI, kB, [](S a) -> Result { return Scalar::of(a[0].i == a[1].i); }, nullptr},
    {Op::kLtInt, "lt", "<", 2, kI, kB, [](S a) -> Result { return Scalar::of(a[0].i < a[1].i); }, nullptr},
    {Op::kLeInt, "le", "<=", 2, kI, kB, [](S a) -> Result { return Scalar::of(a[0].i <= a[1].i); }, nullptr},

    {Op::kToFloat, "float", "", 1, kI, kF, [](S a) -> Result { return Scalar::of(static_cast<double>(a[0].i)); }, nullptr},
    {Op::kFloor, "floor", "", 1, kF, kI, [](S a) { return floor_exactly(a[0].f); },
     [](I) { return Interval{-static_cast<std::int64_t>(kFloorLimit), static_cast<std::int64_t>(kFloorLimit)}; }},
    {Op::kAddFloat, "fadd", "+", 2, kF, kF, [](S a) -> Result { return Scalar::of(a[0].f + a[1].f); }, nullptr},
    {Op::kSubFloat, "fsub", "-", 2, kF, kF, [](S a) -> Result { return Scalar::of(a[0].f - a[1].f); }, nullptr},
    {Op::kMulFloat, "fmul", "*", 2, kF, kF, [](S a) -> Result { return Scalar::of(a[0].f * a[1].f); }, nullptr},
    {Op::kDivFloat, "fdiv", "/", 2, kF, kF, [](S a) { return divide_float(a[0].f, a[1].f); }, nullptr},
    {Op::kNegFloat, "fneg", "-", 1, kF, kF, [](S a) -> Result { return Scalar::of(-a[0].f); }, nullptr},
    {Op::kSqrt, "sqrt", "", 1, kF, kF, [](S a) { return square_root(a[0].f); }, nullptr},
    {Op::kSin, "sin", "", 1, kF, kF, [](S a) -> Result { return Scalar::of(std::sin(a[0].f)); }, nullptr},
    {Op::kCos, "cos", "", 1, kF, kF, [](S a) -> Result { return Scalar::of(std::cos(a[0].f)); }, nullptr},
    {Op::kIteFloat, "if", "", 3, kF, kF, [](S a) -> Result { return a[0].i != 0 ? a[1] : a[2]; }, nullptr},

    {Op::kEqFloat, "feq", "==", 2, kF, kB, [](S a) -> Result { return Scalar::of(a[0].f == a[1].f); }, nullptr},
    {Op::kLtFloat, "flt", "<", 2, kF, kB, [](S a) -> Result { return Scalar::of(a[0].f < a[1].f); }, nullptr},
    {Op::kLeFloat, "fle", "<=", 2, kF, kB, [](S a) -> Result { return Scalar::of(a[0].f <= a[1].f); }, nullptr},
}};
// clang-format on

constexpr bool complete() {
  for (std::size_t i = 0; i < kOpCount; ++i) {
    const Operation& row = kTable[i];
    const bool leaf = row.arity == 0;
    if (row.op != static_cast<Op>(i) || row.name.empty()) return false;
    if (leaf != (row.fold == nullptr)) return false;
    if (!leaf && (row.result == Type::kInt) != (row.bounds != nullptr)) return false;
  }
  return true;
}
static_assert(complete(), "every operation has its row, in the order of enum Op, with a fold and int bounds");

}  // namespace

// Not the table itself: of functions that other files could see, the sanitizers doubt that they are there.
constexpr std::array<Operation, kOpCount> kOperations = kTable;

Op ite_of(Type type) {
  switch (type) {
    case Type::kBool:
      return Op::kIteBool;
    case Type::kInt:
      return Op::kIteInt;
    case Type::kFloat:
      return Op::kIteFloat;
  }
  return Op::kIteInt;
}

}  // namespace solitaire
