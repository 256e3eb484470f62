#include "smt/sat/circuit.h"

#include <algorithm>
#include <utility>

#include "base/hash.h"

namespace solitaire {

Circuit::Circuit() : gates_(1) {}

Literal Circuit::input() {
  gates_.emplace_back();
  return {static_cast<std::uint32_t>(gates_.size() - 1), false};
}

Literal Circuit::conjunction(Literal a, Literal b) {
  if (b < a) std::swap(a, b);
  if (a == kFalseLiteral || a == !b) return kFalseLiteral;
  if (a == kTrueLiteral || a == b) return b;
  return intern(Kind::kAnd, {a, b, {}});
}

Literal Circuit::exclusive_or(Literal a, Literal b) {
  if (b < a) std::swap(a, b);
  if (is_constant(a)) return b ^ a.negated();
  if (a.gate() == b.gate()) return constant_literal(a != b);
  const bool negate = a.negated() != b.negated();
  return intern(Kind::kXor, {a ^ a.negated(), b ^ b.negated(), {}}) ^ negate;
}

Literal Circuit::mux(Literal condition, Literal a, Literal b) {
  if (is_constant(condition)) return condition == kTrueLiteral ? a : b;
  if (a == b) return a;
  if (a == !b) return equivalence(condition, a);
  if (a == kTrueLiteral || a == condition) return disjunction(condition, b);
  if (a == kFalseLiteral || a == !condition) return conjunction(!condition, b);
  if (b == kTrueLiteral || b == !condition) return disjunction(!condition, a);
  if (b == kFalseLiteral || b == condition) return conjunction(condition, a);
  if (condition.negated()) {
    condition = !condition;
    std::swap(a, b);
  }
  const bool negate = a.negated();
  return intern(Kind::kMux, {condition, a ^ negate, b ^ negate}) ^ negate;
}

Literal Circuit::parity(Literal a, Literal b, Literal c) {
  std::array<Literal, 3> x{a, b, c};
  std::sort(x.begin(), x.end());
  if (is_constant(x[0])) return exclusive_or(x[1], x[2]) ^ x[0].negated();
  if (x[0].gate() == x[1].gate()) return x[2] ^ (x[0] != x[1]);
  if (x[1].gate() == x[2].gate()) return x[0] ^ (x[1] != x[2]);
  bool negate = false;
  for (Literal& each : x) {
    negate = negate != each.negated();
    each = each ^ each.negated();
  }
  return intern(Kind::kParity, x) ^ negate;
}

Literal Circuit::majority(Literal a, Literal b, Literal c) {
  std::array<Literal, 3> x{a, b, c};
  std::sort(x.begin(), x.end());
  if (x[0] == kFalseLiteral) return conjunction(x[1], x[2]);
  if (x[0] == kTrueLiteral) return disjunction(x[1], x[2]);
  if (x[0].gate() == x[1].gate()) return x[0] == x[1] ? x[0] : x[2];
  if (x[1].gate() == x[2].gate()) return x[1] == x[2] ? x[1] : x[0];
  const bool negate = x[0].negated();  // it is self-dual
  for (Literal& each : x) each = each ^ negate;
  return intern(Kind::kMajority, x) ^ negate;
}

Literal Circuit::defined(std::unique_ptr<Definition> definition) {
  const Literal number(static_cast<std::uint32_t>(definitions_.size()), false);
  definitions_.push_back(std::move(definition));
  gates_.push_back({Kind::kDefined, {number, {}, {}}, 0});
  return {static_cast<std::uint32_t>(gates_.size() - 1), false};
}

std::uint64_t Circuit::hash(const Gate& gate) {
  const auto [a, b, c] = gate.operands;  // operands that a gate does not have are 0
  return mix(std::uint64_t{a.code()} << 32 | b.code(),
             std::uint64_t{c.code()} << 32 | static_cast<std::uint64_t>(gate.kind));
}

Literal Circuit::intern(Kind kind, std::array<Literal, 3> operands) {
  const Gate made{kind, operands, 0};
  const auto equals = [&](std::uint32_t number) { return gates_[number] == made; };
  const auto add = [&] {
    for (const Literal operand : operands) gates_[operand.gate()].uses += kind == Kind::kAnd ? 1 : 2;
    gates_.push_back(made);
    return static_cast<std::uint32_t>(gates_.size() - 1);
  };
  return {table_.find_or_add(hash(made), equals, add), false};
}

}  // namespace solitaire
