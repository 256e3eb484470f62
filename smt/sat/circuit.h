#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/unique_table.h"

namespace solitaire {

/// A gate of a Circuit or its negation.
class Literal {
 public:
  constexpr Literal() = default;
  constexpr Literal(std::uint32_t gate, bool negated) : code_(2 * gate + (negated ? 1 : 0)) {}

  constexpr std::uint32_t gate() const { return code_ / 2; }
  constexpr bool negated() const { return code_ % 2 != 0; }
  /// Returns a number for each literal, without gaps, so that literals can index vectors.
  constexpr std::uint32_t code() const { return code_; }
  constexpr Literal operator!() const { return *this ^ true; }
  constexpr Literal operator^(bool negate) const { return {gate(), negated() != negate}; }
  friend constexpr auto operator<=>(Literal, Literal) = default;

 private:
  std::uint32_t code_ = 0;
};
/// Gate 0 is the constant.
inline constexpr Literal kFalseLiteral{0, false};
inline constexpr Literal kTrueLiteral{0, true};
constexpr bool is_constant(Literal literal) { return literal.gate() == 0; }
constexpr Literal constant_literal(bool value) { return kFalseLiteral ^ value; }

struct OrderEncodedInt;

/// Says how two ints in order encoding (order_encoded_int.h) compare.
struct OrderedPair {
  enum class Relation : std::uint8_t { kLess, kLessOrEqual, kDifferent };
  const OrderEncodedInt* a = nullptr;
  const OrderEncodedInt* b = nullptr;
  Relation relation = Relation::kLess;
};

/// Says that the sum of multiples of ints in order encoding is no less than a number.
struct LinearBound {
  struct Term {
    const OrderEncodedInt* of = nullptr;
    std::int64_t factor = 1;
  };
  std::vector<Term> terms;
  std::int64_t least = 0;
};

/// Says what a literal means, by clauses that hold where the literal does, and others that hold where its
/// negation does. Whoever makes the literal provides both lists. No assignment may fulfil both.
class Definition {
 public:
  using Emit = std::function<void(std::span<const Literal> clause)>;
  virtual ~Definition() = default;
  virtual void write(bool negated, const Emit& emit) const = 0;
  /// Returns comparisons that together say the same as write(), or nothing if there are none.
  virtual std::vector<OrderedPair> comparisons(bool /*negated*/) const { return {}; }
  /// Returns true if linear() says the same as write(). It has to be asked for by itself.
  virtual bool is_linear() const { return false; }
  virtual LinearBound linear(bool /*negated*/) const { return {}; }
};

/// A hash-consed circuit: equal gates are one gate. A gate with constant, equal or opposite operands is
/// simplified when it is made, so that the circuit has none.
class Circuit {
 public:
  enum class Kind : std::uint8_t { kInput, kAnd, kXor, kMux, kParity, kMajority, kDefined };
  struct Gate {
    Kind kind = Kind::kInput;
    std::array<Literal, 3> operands{};
    std::uint32_t uses = 0;  // by other gates; one that needs both signs counts as two uses
    friend bool operator==(const Gate& a, const Gate& b) {
      return a.kind == b.kind && a.operands == b.operands;
    }
  };

  Circuit();

  Literal input();
  Literal conjunction(Literal a, Literal b);
  Literal disjunction(Literal a, Literal b) { return !conjunction(!a, !b); }
  Literal exclusive_or(Literal a, Literal b);
  Literal equivalence(Literal a, Literal b) { return !exclusive_or(a, b); }
  /// Returns a literal that is `a` where the condition holds, and `b` elsewhere.
  Literal mux(Literal condition, Literal a, Literal b);
  /// Returns a literal that holds where an odd number of them does, as the sum of a full adder.
  Literal parity(Literal a, Literal b, Literal c);
  /// Returns a literal that holds where at least two of them do, as the carry of a full adder.
  Literal majority(Literal a, Literal b, Literal c);
  /// Makes a gate that nothing else is equal to. Whoever makes it counts the uses of the literals in its
  /// clauses.
  Literal defined(std::unique_ptr<Definition> definition);

  const Gate& gate(Literal literal) const { return gates_[literal.gate()]; }
  /// Returns the definition of a gate of the kind kDefined.
  const Definition& definition(Literal literal) const {
    return *definitions_[gate(literal).operands[0].gate()];
  }
  std::size_t size() const { return gates_.size(); }
  /// Counts a use of the literal outside of the circuit.
  void use(Literal literal) { ++gates_[literal.gate()].uses; }

 private:
  Literal intern(Kind kind, std::array<Literal, 3> operands);
  static std::uint64_t hash(const Gate& gate);

  std::vector<Gate> gates_;
  std::vector<std::unique_ptr<Definition>> definitions_;
  UniqueTable table_;  // contains the gates that have operands
};

}  // namespace solitaire
