#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "tracegraph/interval.h"

namespace solitaire {

enum class Type : std::uint8_t { kBool, kInt, kFloat };

/// The operations of the trace graph. One table (operation()) says everything about each of them but how a
/// solver encodes it, which smt/encode.cpp says in a table of the same order.
// clang-format off
enum class Op : std::uint8_t {
  kConstBool, kConstInt, kConstFloat, kChoice,
  kNot, kAnd, kOr, kEqBool, kIteBool,
  kAdd, kSub, kMul, kDiv, kMod, kNeg, kMin, kMax, kAbs, kIteInt,
  kEqInt, kLtInt, kLeInt,
  kToFloat, kFloor, kAddFloat, kSubFloat, kMulFloat, kDivFloat, kNegFloat, kSqrt, kSin, kCos, kIteFloat,
  kEqFloat, kLtFloat, kLeFloat,
  kCount_
};
// clang-format on
inline constexpr std::size_t kOpCount = static_cast<std::size_t>(Op::kCount_);

/// A constant of any type, untagged: `i` for ints and, as 0 or 1, bools; `f` for floats.
union Scalar {
  std::int64_t i;
  double f;

  static constexpr Scalar of(std::int64_t value) { return {.i = value}; }
  static constexpr Scalar of(bool value) { return {.i = value ? 1 : 0}; }
  static constexpr Scalar of(double value) { return {.f = value}; }
};

/// What an operation means on constants; nothing where it has no meaning (division by zero, an int past
/// kIntLimit).
using Fold = std::optional<Scalar> (*)(const Scalar* operands);
/// Bounds of an int result, given bounds of the operands; may lie outside the exact range.
using Bounds = Interval (*)(const Interval* operands);

struct Operation {
  Op op;
  std::string_view name;    // as SMT-LIB-like prefix text, used by dot output
  std::string_view symbol;  // as the language writes it, used by text output; empty: name(a, b)
  std::uint8_t arity;
  Type operand;  // of every operand but the condition of an ite, which is a bool
  Type result;
  Fold fold;      // null for leaves
  Bounds bounds;  // null unless the result is an int
};

extern const std::array<Operation, kOpCount> kOperations;
inline const Operation& operation(Op op) { return kOperations[static_cast<std::size_t>(op)]; }

/// The ite (phi) of that type: ite(condition, then, else).
Op ite_of(Type type);

}  // namespace solitaire
