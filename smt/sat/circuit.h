#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
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
  /// Dense: literals can be numbers of a vector.
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

/// That a number is no larger than another one, or smaller; both are told by order (order.h).
struct OrderedPair {
  const OrderEncodedInt* smaller = nullptr;
  const OrderEncodedInt* larger = nullptr;
  bool strict = false;
};

/// What a literal means, said by whoever makes it: clauses that follow from it, and others from its negation.
/// No assignment may fulfil both lists.
class Definition {
 public:
  using Emit = std::function<void(std::initializer_list<Literal> clause)>;
  virtual ~Definition() = default;
  virtual void write(bool negated, const Emit& emit) const = 0;
  /// The same, if it can be said so, by comparisons that all hold; else nothing.
  virtual std::vector<OrderedPair> comparisons(bool /*negated*/) const { return {}; }
};

/// A hash-consed circuit: equal gates are one, and none has a constant, equal or opposite operands, as all
/// that folds away when it is made.
class Circuit {
 public:
  enum class Kind : std::uint8_t { kInput, kAnd, kXor, kMux, kParity, kMajority, kDefined };
  struct Gate {
    Kind kind = Kind::kInput;
    std::array<Literal, 3> operands{};
    std::uint32_t uses = 0;  // by other gates, one that needs both signs counts twice
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
  /// a where the condition holds, else b.
  Literal mux(Literal condition, Literal a, Literal b);
  /// Whether an odd number of them holds: the sum of a full adder.
  Literal parity(Literal a, Literal b, Literal c);
  /// Whether at least two of them hold: the carry of a full adder.
  Literal majority(Literal a, Literal b, Literal c);
  /// A gate of its own. The maker counts the uses of the literals in its clauses.
  Literal defined(std::unique_ptr<Definition> definition);

  const Gate& gate(Literal literal) const { return gates_[literal.gate()]; }
  /// Of a gate of the kind kDefined.
  const Definition& definition(Literal literal) const {
    return *definitions_[gate(literal).operands[0].gate()];
  }
  std::size_t size() const { return gates_.size(); }
  /// Counts a use from outside.
  void use(Literal literal) { ++gates_[literal.gate()].uses; }

 private:
  Literal intern(Kind kind, std::array<Literal, 3> operands);
  static std::uint64_t hash(const Gate& gate);

  std::vector<Gate> gates_;
  std::vector<std::unique_ptr<Definition>> definitions_;
  UniqueTable table_;  // of the gates that have operands
};

}  // namespace solitaire
