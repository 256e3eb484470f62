#pragma once
#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "base/hash.h"

namespace solitaire {

enum class Type : std::uint8_t { kBool, kInt, kFloat };

/// Returns "a bool", "an int" or "a float".
const char* in_words(Type type);

class PairTable;

/// A constant of any type, untagged: `i` for ints and, as 0 or 1, bools; `f` for floats; `table` where an
/// operation looks two ints up.
union Scalar {
  std::int64_t i;
  double f;
  const PairTable* table;

  static constexpr Scalar of(std::int64_t value) { return {.i = value}; }
  static constexpr Scalar of(bool value) { return {.i = value ? 1 : 0}; }
  static constexpr Scalar of(double value) { return {.f = value}; }
};

/// A bool, an int or a float that knows which it is: the value of a choice.
///
/// Values of different types are different, also true and 1. Floats are compared as numbers, so that 0.0 and
/// -0.0 are equal; a choice is never NaN.
class TypedScalar {
 public:
  /// The int 0.
  constexpr TypedScalar() : TypedScalar(Type::kInt, Scalar::of(std::int64_t{0})) {}
  constexpr TypedScalar(Type type, Scalar value) : type_(type), value_(value) {}

  static constexpr TypedScalar of(bool value) { return {Type::kBool, Scalar::of(value)}; }
  static constexpr TypedScalar of(std::int64_t value) { return {Type::kInt, Scalar::of(value)}; }
  static constexpr TypedScalar of(double value) { return {Type::kFloat, Scalar::of(value)}; }

  constexpr Type type() const { return type_; }
  constexpr Scalar scalar() const { return value_; }
  /// The int, or 0 or 1 for a bool. Only for these two types.
  constexpr std::int64_t as_int() const { return value_.i; }
  /// The float; an int or a bool is converted.
  constexpr double as_float() const {
    return type_ == Type::kFloat ? value_.f : static_cast<double>(value_.i);
  }

  friend constexpr bool operator==(TypedScalar a, TypedScalar b) { return (a <=> b) == 0; }
  /// Values are ordered by type, then by value.
  friend constexpr std::partial_ordering operator<=>(TypedScalar a, TypedScalar b) {
    if (a.type_ != b.type_) return a.type_ <=> b.type_;
    if (a.type_ == Type::kFloat) return a.value_.f <=> b.value_.f;
    return a.value_.i <=> b.value_.i;
  }

 private:
  Type type_;
  Scalar value_;
};

/// Returns the value as one of that type, where it can stand for one: an int for a float, and the ints 0 and
/// 1 for false and true. Every value stands for itself. Returns nothing for all else.
std::optional<TypedScalar> converted(TypedScalar value, Type type);

/// The value as the language writes it: true, 3, 0.5. A float gets the fewest digits that say exactly this
/// one, and always a point or an exponent.
std::string to_text(TypedScalar value);

}  // namespace solitaire

template <>
struct std::hash<solitaire::TypedScalar> {
  std::size_t operator()(solitaire::TypedScalar value) const noexcept {
    const auto type = static_cast<std::uint64_t>(value.type());
    if (value.type() != solitaire::Type::kFloat)
      return solitaire::mix(type, static_cast<std::uint64_t>(value.as_int()));
    return solitaire::mix(type, std::hash<double>{}(value.as_float()));
  }
};
