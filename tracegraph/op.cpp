#include "tracegraph/op.h"

#include <cmath>

#include "base/floor_division.h"
#include "tracegraph/pair_table.h"
#include "tracegraph/special_functions.h"

namespace solitaire {
namespace {

using Folded = std::optional<Scalar>;

Folded exact(std::int64_t value) {
  if (!is_exact(value)) return std::nullopt;
  return Scalar::of(value);
}

Folded multiply_exactly(std::int64_t a, std::int64_t b) {
  std::int64_t product = 0;
  if (__builtin_mul_overflow(a, b, &product)) return std::nullopt;
  return exact(product);
}

Folded floor_quotient(std::int64_t a, std::int64_t b) {
  if (b == 0) return std::nullopt;
  return Scalar::of(floor_divide(a, b));
}

Folded floor_rest(std::int64_t a, std::int64_t b) {
  if (b == 0) return std::nullopt;
  return Scalar::of(floor_modulo(a, b));
}

/// Past 2^53 a double no longer tells neighbouring ints apart.
constexpr double kFloorLimit = 9007199254740992.0;

Folded floor_exactly(double value) {
  const double floor = std::floor(value);
  if (!(std::abs(floor) <= kFloorLimit)) return std::nullopt;
  return Scalar::of(static_cast<std::int64_t>(floor));
}

/// Gives nothing where a result is past the largest float.
Folded finite(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  return Scalar::of(value);
}

/// Gives nothing where finite operands lead past the largest float, or infinite ones to no number. An operand
/// is infinite after an exp or pow of something large; so a logistic curve 1 / (1 + exp(-x)) ends in 0.
Folded from_operands(double result, const Scalar* a) {
  const bool grows = std::isinf(result) && std::isfinite(a[0].f) && std::isfinite(a[1].f);
  if (grows || std::isnan(result)) return std::nullopt;
  return Scalar::of(result);
}

Folded divide_float(const Scalar* a) {
  if (a[1].f == 0) return std::nullopt;
  return from_operands(a[0].f / a[1].f, a);
}

/// Gives nothing where a function is undefined although none of its operands is.
Folded unless_undefined(double value) {
  if (std::isnan(value)) return std::nullopt;
  return Scalar::of(value);
}

Folded logarithm(double a) {
  if (a <= 0) return std::nullopt;
  return Scalar::of(std::log(a));
}

// d/da a^b = b a^(b-1); d/db a^b = a^b ln a, which exists where a is positive. Where the base is 0 or
// negative the power is only defined for some exponents, so that there is no slope along b; it is taken as 0.
void power_derivative(const Scalar* a, double result, double* partials) {
  partials[0] = a[1].f == 0 ? 0 : a[1].f * std::pow(a[0].f, a[1].f - 1);
  partials[1] = a[0].f > 0 ? result * std::log(a[0].f) : 0;
}

void atan2_derivative(const Scalar* a, double, double* partials) {
  const double square = a[0].f * a[0].f + a[1].f * a[1].f;
  partials[0] = a[1].f / square;
  partials[1] = -a[0].f / square;
}

void taken(bool first, double* partials) {
  partials[0] = first ? 1 : 0;
  partials[1] = first ? 0 : 1;
}

using S = const Scalar*;
using I = const Interval*;
using P = double*;
constexpr Type kB = Type::kBool;
constexpr Type kI = Type::kInt;
constexpr Type kF = Type::kFloat;
constexpr bool kCommutative = true;
constexpr bool kOrdered = false;

// clang-format off
constexpr std::array<Operation, kOpCount> kTable = {{
    {Op::kConstBool, "bool", "", 0, kB, kB, nullptr, nullptr},
    {Op::kConstInt, "int", "", 0, kI, kI, nullptr, nullptr},
    {Op::kConstFloat, "float", "", 0, kF, kF, nullptr, nullptr},
    {Op::kConstTable, "table", "", 0, kI, kI, nullptr, nullptr},
    {Op::kChoice, "range", "", 0, kI, kI, nullptr, nullptr},
    {Op::kChoiceFloat, "draw", "", 0, kF, kF, nullptr, nullptr},

    {Op::kNot, "not", "not", 1, kB, kB, [](S a) -> Folded { return Scalar::of(a[0].i == 0); }, nullptr},
    {Op::kAnd, "and", "and", 2, kB, kB, [](S a) -> Folded { return Scalar::of(a[0].i != 0 && a[1].i != 0); }, nullptr, kCommutative},
    {Op::kOr, "or", "or", 2, kB, kB, [](S a) -> Folded { return Scalar::of(a[0].i != 0 || a[1].i != 0); }, nullptr, kCommutative},
    {Op::kEqBool, "iff", "==", 2, kB, kB, [](S a) -> Folded { return Scalar::of(a[0].i == a[1].i); }, nullptr, kCommutative},
    {Op::kIteBool, "if", "", 3, kB, kB, [](S a) -> Folded { return a[0].i != 0 ? a[1] : a[2]; }, nullptr},

    {Op::kAdd, "add", "+", 2, kI, kI, [](S a) { return exact(a[0].i + a[1].i); }, [](I a) { return add(a[0], a[1]); }, kCommutative},
    {Op::kSub, "sub", "-", 2, kI, kI, [](S a) { return exact(a[0].i - a[1].i); }, [](I a) { return subtract(a[0], a[1]); }},
    {Op::kMul, "mul", "*", 2, kI, kI, [](S a) { return multiply_exactly(a[0].i, a[1].i); }, [](I a) { return multiply(a[0], a[1]); }, kCommutative},
    {Op::kDiv, "div", "/", 2, kI, kI, [](S a) { return floor_quotient(a[0].i, a[1].i); }, [](I a) { return divide(a[0], a[1]); }},
    {Op::kMod, "mod", "%", 2, kI, kI, [](S a) { return floor_rest(a[0].i, a[1].i); }, [](I a) { return modulo(a[0], a[1]); }},
    {Op::kNeg, "neg", "-", 1, kI, kI, [](S a) -> Folded { return Scalar::of(-a[0].i); }, [](I a) { return negate(a[0]); }},
    {Op::kMin, "min", "", 2, kI, kI, [](S a) -> Folded { return Scalar::of(std::min(a[0].i, a[1].i)); }, [](I a) { return minimum(a[0], a[1]); }, kCommutative},
    {Op::kMax, "max", "", 2, kI, kI, [](S a) -> Folded { return Scalar::of(std::max(a[0].i, a[1].i)); }, [](I a) { return maximum(a[0], a[1]); }, kCommutative},
    {Op::kAbs, "abs", "", 1, kI, kI, [](S a) -> Folded { return Scalar::of(std::abs(a[0].i)); }, [](I a) { return absolute(a[0]); }},
    {Op::kIteInt, "if", "", 3, kI, kI, [](S a) -> Folded { return a[0].i != 0 ? a[1] : a[2]; }, [](I a) { return hull(a[1], a[2]); }},

    {Op::kEqInt, "eq", "==", 2, kI, kB, [](S a) -> Folded { return Scalar::of(a[0].i == a[1].i); }, nullptr, kCommutative},
    {Op::kLtInt, "lt", "<", 2, kI, kB, [](S a) -> Folded { return Scalar::of(a[0].i < a[1].i); }, nullptr},
    {Op::kLeInt, "le", "<=", 2, kI, kB, [](S a) -> Folded { return Scalar::of(a[0].i <= a[1].i); }, nullptr},
    {Op::kAllowed, "allowed", "", 3, kI, kB, [](S a) -> Folded { return Scalar::of(a[2].table->allows(a[0].i, a[1].i)); }, nullptr},

    {Op::kToFloat, "float", "", 1, kI, kF, [](S a) -> Folded { return Scalar::of(static_cast<double>(a[0].i)); }, nullptr},
    {Op::kFloor, "floor", "", 1, kF, kI, [](S a) { return floor_exactly(a[0].f); },
     [](I) { return Interval{-static_cast<std::int64_t>(kFloorLimit), static_cast<std::int64_t>(kFloorLimit)}; }},
    {Op::kAddFloat, "fadd", "+", 2, kF, kF, [](S a) { return from_operands(a[0].f + a[1].f, a); }, nullptr, kCommutative, [](S, double, P d) { d[0] = 1; d[1] = 1; }},
    {Op::kSubFloat, "fsub", "-", 2, kF, kF, [](S a) { return from_operands(a[0].f - a[1].f, a); }, nullptr, kOrdered, [](S, double, P d) { d[0] = 1; d[1] = -1; }},
    {Op::kMulFloat, "fmul", "*", 2, kF, kF, [](S a) { return from_operands(a[0].f * a[1].f, a); }, nullptr, kCommutative, [](S a, double, P d) { d[0] = a[1].f; d[1] = a[0].f; }},
    {Op::kDivFloat, "fdiv", "/", 2, kF, kF, divide_float, nullptr, kOrdered, [](S a, double r, P d) { d[0] = 1 / a[1].f; d[1] = -r / a[1].f; }},
    {Op::kNegFloat, "fneg", "-", 1, kF, kF, [](S a) -> Folded { return Scalar::of(-a[0].f); }, nullptr, kOrdered, [](S, double, P d) { d[0] = -1; }},
    {Op::kMinFloat, "fmin", "", 2, kF, kF, [](S a) -> Folded { return a[1].f < a[0].f ? a[1] : a[0]; }, nullptr, kOrdered, [](S a, double, P d) { taken(!(a[1].f < a[0].f), d); }},
    {Op::kMaxFloat, "fmax", "", 2, kF, kF, [](S a) -> Folded { return a[0].f < a[1].f ? a[1] : a[0]; }, nullptr, kOrdered, [](S a, double, P d) { taken(!(a[0].f < a[1].f), d); }},
    {Op::kSqrt, "sqrt", "", 1, kF, kF, [](S a) { return unless_undefined(std::sqrt(a[0].f)); }, nullptr, kOrdered, [](S, double r, P d) { d[0] = 0.5 / r; }},
    {Op::kExp, "exp", "", 1, kF, kF, [](S a) -> Folded { return Scalar::of(std::exp(a[0].f)); }, nullptr, kOrdered, [](S, double r, P d) { d[0] = r; }},
    {Op::kLog, "log", "", 1, kF, kF, [](S a) { return logarithm(a[0].f); }, nullptr, kOrdered, [](S a, double, P d) { d[0] = 1 / a[0].f; }},
    {Op::kPow, "pow", "", 2, kF, kF, [](S a) { return unless_undefined(std::pow(a[0].f, a[1].f)); }, nullptr, kOrdered, power_derivative},
    {Op::kLgamma, "lgamma", "", 1, kF, kF, [](S a) { return finite(log_gamma(a[0].f)); }, nullptr, kOrdered, [](S a, double, P d) { d[0] = digamma(a[0].f); }},
    {Op::kSin, "sin", "", 1, kF, kF, [](S a) -> Folded { return Scalar::of(std::sin(a[0].f)); }, nullptr, kOrdered, [](S a, double, P d) { d[0] = std::cos(a[0].f); }},
    {Op::kCos, "cos", "", 1, kF, kF, [](S a) -> Folded { return Scalar::of(std::cos(a[0].f)); }, nullptr, kOrdered, [](S a, double, P d) { d[0] = -std::sin(a[0].f); }},
    {Op::kAtan2, "atan2", "", 2, kF, kF, [](S a) -> Folded { return Scalar::of(std::atan2(a[0].f, a[1].f)); }, nullptr, kOrdered, atan2_derivative},
    {Op::kIteFloat, "if", "", 3, kF, kF, [](S a) -> Folded { return a[0].i != 0 ? a[1] : a[2]; }, nullptr, kOrdered, [](S a, double, P d) { taken(a[0].i != 0, d + 1); }},

    {Op::kEqFloat, "feq", "==", 2, kF, kB, [](S a) -> Folded { return Scalar::of(a[0].f == a[1].f); }, nullptr, kCommutative},
    {Op::kLtFloat, "flt", "<", 2, kF, kB, [](S a) -> Folded { return Scalar::of(a[0].f < a[1].f); }, nullptr},
    {Op::kLeFloat, "fle", "<=", 2, kF, kB, [](S a) -> Folded { return Scalar::of(a[0].f <= a[1].f); }, nullptr},
}};
// clang-format on

constexpr bool complete() {
  for (std::size_t i = 0; i < kOpCount; ++i) {
    const Operation& row = kTable[i];
    const bool leaf = row.arity == 0;
    if (row.op != static_cast<Op>(i) || row.name.empty()) return false;
    if (leaf != (row.fold == nullptr)) return false;
    if (!leaf && (row.result == Type::kInt) != (row.bounds != nullptr)) return false;
    if (row.commutative && row.arity != 2) return false;
    const bool smooth = !leaf && row.operand == Type::kFloat && row.result == Type::kFloat;
    if (smooth != (row.derivative != nullptr)) return false;
  }
  return true;
}
static_assert(complete(),
              "every operation has its row, in the order of enum Op, with a fold, int bounds and derivative");

}  // namespace

// The checks look at this copy, because the sanitizers do not take the address of a function that other files
// can see for a constant.
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
