#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "tracegraph/interval.h"
#include "tracegraph/scalar.h"

namespace solitaire {

/// The operations of the trace graph. One table (operation()) says everything about each of them but how a
/// solver encodes it, which smt/ says in tables of the same order.
// clang-format off
enum class Op : std::uint8_t {
  kConstBool, kConstInt, kConstFloat, kConstTable, kChoice, kChoiceFloat,
  kNot, kAnd, kOr, kEqBool, kIteBool,
  kAdd, kSub, kMul, kDiv, kMod, kNeg, kMin, kMax, kAbs, kIteInt,
  kEqInt, kLtInt, kLeInt, kAllowed,
  kToFloat, kFloor, kAddFloat, kSubFloat, kMulFloat, kDivFloat, kNegFloat, kMinFloat, kMaxFloat,
  kSqrt, kExp, kLog, kPow, kLgamma, kSin, kCos, kAtan2, kIteFloat,
  kEqFloat, kLtFloat, kLeFloat,
  kCount_
};
// clang-format on
inline constexpr std::size_t kOpCount = static_cast<std::size_t>(Op::kCount_);

/// Computes the result of an operation on constants. It gives nothing where the operation has no meaning: a
/// division by zero, an int past kIntLimit, the square root or logarithm of a negative number. Float
/// arithmetic follows IEEE 754 and may give an infinity where a result is too large.
using Fold = std::optional<Scalar> (*)(const Scalar* operands);
/// Bounds of an int result, given bounds of the operands. They may lie outside the exact range.
using Bounds = Interval (*)(const Interval* operands);
/// The partial derivative of a float result by each float operand, at the operands' values and the result
/// that they fold to. Entries for operands that are no floats are left alone. Where the function has a kink
/// (min, max at equal operands), the derivative is that of the operand that the fold takes.
using Derivative = void (*)(const Scalar* operands, double result, double* partials);

struct Operation {
  Op op;
  std::string_view name;    // in prefix notation, for drawings of the graph
  std::string_view symbol;  // in infix notation, as in the language; if empty, text has name(a, b)
  std::uint8_t arity;
  Type operand;  // the type of all operands, except that the condition of an ite is a bool
  Type result;
  Fold fold;                        // null for leaves
  Bounds bounds;                    // null unless the result is an int
  bool commutative = false;         // f(a, b) equals f(b, a)
  Derivative derivative = nullptr;  // null unless the result is a float that depends smoothly on floats

  /// Returns true if an operand or the result is a float. Bit-vectors and clauses cannot express such an
  /// operation.
  constexpr bool on_floats() const { return operand == Type::kFloat || result == Type::kFloat; }
};

extern const std::array<Operation, kOpCount> kOperations;
inline const Operation& operation(Op op) { return kOperations[static_cast<std::size_t>(op)]; }

/// Returns true if nodes of the operation are choices that were left open.
constexpr bool is_choice(Op op) { return op == Op::kChoice || op == Op::kChoiceFloat; }

/// Returns true if the first operand of the operation, a bool, selects one of the two others.
constexpr bool is_ite(Op op) { return op == Op::kIteBool || op == Op::kIteInt || op == Op::kIteFloat; }

/// Returns true if the last operand of the operation is a table of pairs, as Graph::table() makes it.
constexpr bool has_table(Op op) { return op == Op::kAllowed; }

/// The ite (phi) of that type: ite(condition, then, else).
Op ite_of(Type type);

}  // namespace solitaire
