#include "smt/bit_blast.h"

#include <array>
#include <bit>
#include <stdexcept>

namespace solitaire {

/// The circuit column of the operation table, in the order of enum Op. Null: no bits say it.
struct BitBlasts {
  using B = BitBlaster&;
  using N = const NodeId*;
  using W = std::size_t;  // the width of an int result
  using BitBlast = Bits (*)(BitBlaster&, std::size_t width, const NodeId* operands);

  struct Row {
    Op op;
    BitBlast blast;
  };

  static constexpr std::array<Row, kOpCount> kTable = {{
      {Op::kConstBool, [](B b, W, N a) -> Bits { return {constant_literal(b.interval(*a).lo != 0)}; }},
      {Op::kConstInt, [](B b, W w, N a) { return constant_bits(b.interval(*a).lo, w); }},
      {Op::kConstFloat, nullptr},
      {Op::kChoice, [](B b, W, N a) { return b.blast_choice(*a); }},

      {Op::kNot, [](B b, W, N a) -> Bits { return {!b.literal(a[0])}; }},
      {Op::kAnd,
       [](B b, W, N a) -> Bits { return {b.circuit_.conjunction(b.literal(a[0]), b.literal(a[1]))}; }},
      {Op::kOr,
       [](B b, W, N a) -> Bits { return {b.circuit_.disjunction(b.literal(a[0]), b.literal(a[1]))}; }},
      {Op::kEqBool,
       [](B b, W, N a) -> Bits { return {b.circuit_.equivalence(b.literal(a[0]), b.literal(a[1]))}; }},
      {Op::kIteBool,
       [](B b, W, N a) -> Bits {
         return {b.circuit_.mux(b.literal(a[0]), b.literal(a[1]), b.literal(a[2]))};
       }},

      {Op::kAdd, [](B b, W w, N a) { return add(b.circuit_, b.sized(a[0], w), b.sized(a[1], w)); }},
      {Op::kSub, [](B b, W w, N a) { return subtract(b.circuit_, b.sized(a[0], w), b.sized(a[1], w)); }},
      {Op::kMul, [](B b, W w, N a) { return b.product(a[0], a[1], w); }},
      {Op::kDiv, [](B b, W w, N a) { return b.quotient(a[0], a[1], w); }},
      {Op::kMod, [](B b, W w, N a) { return b.modulus(a[0], a[1], w); }},
      {Op::kNeg, [](B b, W w, N a) { return negate_if(b.circuit_, kTrueLiteral, b.sized(a[0], w)); }},
      {Op::kMin, [](B b, W w, N a) { return b.extreme(a[0], a[1], true, w); }},
      {Op::kMax, [](B b, W w, N a) { return b.extreme(a[0], a[1], false, w); }},
      {Op::kAbs, [](B b, W w, N a) { return negate_if(b.circuit_, b.bits(a[0]).back(), b.sized(a[0], w)); }},
      {Op::kIteInt,
       [](B b, W w, N a) { return select(b.circuit_, b.literal(a[0]), b.sized(a[1], w), b.sized(a[2], w)); }},

      {Op::kEqInt, [](B b, W, N a) -> Bits { return {b.equality(a[0], a[1])}; }},
      {Op::kLtInt, [](B b, W, N a) -> Bits { return {b.comparison(a[0], a[1], false)}; }},
      {Op::kLeInt, [](B b, W, N a) -> Bits { return {b.comparison(a[0], a[1], true)}; }},

      {Op::kToFloat, nullptr},
      {Op::kFloor, nullptr},
      {Op::kAddFloat, nullptr},
      {Op::kSubFloat, nullptr},
      {Op::kMulFloat, nullptr},
      {Op::kDivFloat, nullptr},
      {Op::kNegFloat, nullptr},
      {Op::kSqrt, nullptr},
      {Op::kSin, nullptr},
      {Op::kCos, nullptr},
      {Op::kIteFloat, nullptr},
      {Op::kEqFloat, nullptr},
      {Op::kLtFloat, nullptr},
      {Op::kLeFloat, nullptr},
  }};

  static constexpr bool in_order() {
    for (std::size_t i = 0; i < kOpCount; ++i) {
      if (kTable[i].op != static_cast<Op>(i)) return false;
    }
    return true;
  }
};
static_assert(BitBlasts::in_order(), "every operation has its circuit, in the order of enum Op");

Literal BitBlaster::condition(NodeId node) {
  blast(node);
  return literal(node);
}

void BitBlaster::add_alternatives(NodeId condition, std::vector<Literal>& literals) {
  const Graph::Node& negation = graph_.node(condition);
  const Graph::Node& equality = graph_.node(negation.operands[0]);
  const auto [choice, constant, unused] = equality.operands;
  if (negation.op != Op::kNot || equality.op != Op::kEqInt || graph_.node(choice).op != Op::kChoice ||
      !graph_.node(constant).is_constant()) {
    literals.push_back(this->condition(condition));
    return;
  }
  blast(choice);
  const std::size_t variable = graph_.node(choice).payload;
  const std::uint64_t value = bits_of(variable, interval(constant).lo);
  for (std::size_t i = 0; i < choices_[variable].size(); ++i) {
    literals.push_back(choices_[variable][i] ^ (((value >> i) & 1) != 0));
  }
}

/// Operands first, on an own stack: the graph can be deeper than the machine's.
void BitBlaster::blast(NodeId node) {
  nodes_.resize(graph_.size());
  std::vector<NodeId> pending{node};
  while (!pending.empty()) {
    const NodeId at = pending.back();
    const std::size_t waiting = pending.size();
    if (nodes_[at.index].empty()) {
      for (const NodeId operand : graph_.node(at).args()) {
        if (nodes_[operand.index].empty()) pending.push_back(operand);
      }
      if (pending.size() > waiting) continue;
      nodes_[at.index] = blast_node(at);
    }
    pending.pop_back();
  }
}

Bits BitBlaster::blast_node(NodeId id) {
  const Graph::Node& node = graph_.node(id);
  const BitBlasts::BitBlast compile = BitBlasts::kTable[static_cast<std::size_t>(node.op)].blast;
  if (compile == nullptr) throw std::logic_error("a float operation came to the bit-blaster");
  const NodeId* operands = operation(node.op).arity == 0 ? &id : node.operands.data();
  if (node.type() != Type::kInt) return compile(*this, 0, operands);
  return with_known_bits(compile(*this, static_cast<std::size_t>(bit_width(node.interval)), operands),
                         node.interval);
}

/// Upper bits that all values of the interval have in common are constants.
Bits BitBlaster::with_known_bits(Bits bits, Interval interval) const {
  const auto differing = static_cast<std::uint64_t>(interval.lo ^ interval.hi);
  for (auto i = static_cast<std::size_t>(std::bit_width(differing)); i < bits.size(); ++i) {
    bits[i] = constant_literal(((interval.lo >> i) & 1) != 0);
  }
  return bits;
}

/// A choice of step 1 is a number with bounds; one of a larger step counts its steps from the lower end.
Bits BitBlaster::blast_choice(NodeId id) {
  const std::size_t number = graph_.node(id).payload;
  const ChoiceDomain& domain = graph_.variable(id).domain;
  const Interval values = interval(id);
  if (choices_.size() <= number) choices_.resize(number + 1);
  if (domain.step == 1) return choices_[number] = bounded_input(values);
  const Bits& steps = choices_[number] = bounded_input({0, (values.hi - values.lo) / domain.step});
  const auto bits = static_cast<std::size_t>(bit_width(values));
  return add(circuit_, multiply(circuit_, resized(steps, bits, false), domain.step),
             constant_bits(values.lo, bits));
}

Bits BitBlaster::bounded_input(Interval interval) {
  Bits bits(static_cast<std::size_t>(bit_width(interval)));
  for (Literal& bit : bits) bit = circuit_.input();
  bits = with_known_bits(std::move(bits), interval);
  Bits lo = constant_bits(interval.lo, bits.size());
  Bits hi = constant_bits(interval.hi, bits.size());
  Bits offset = bits;
  if (interval.lo < 0) {
    for (Bits* each : {&lo, &hi, &offset}) each->back() = !each->back();
  }
  for (const Literal bound : {less(circuit_, lo, offset, true), less(circuit_, offset, hi, true)}) {
    cnf_.add_clause({&bound, 1});
  }
  return bits;
}

std::span<const Literal> BitBlaster::choice_bits(std::size_t variable) const {
  if (variable >= choices_.size()) return {};
  return choices_[variable];
}

std::int64_t BitBlaster::decode(std::size_t variable, std::uint64_t bits) const {
  const ChoiceDomain& domain = graph_.variables()[variable].domain;
  if (domain.step != 1) return domain.lo + static_cast<std::int64_t>(bits) * domain.step;
  const int unused = 64 - bit_width({domain.lo, domain.hi});
  if (domain.lo >= 0) return static_cast<std::int64_t>(bits);
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

std::uint64_t BitBlaster::bits_of(std::size_t variable, std::int64_t value) const {
  const ChoiceDomain& domain = graph_.variables()[variable].domain;
  return static_cast<std::uint64_t>(domain.step == 1 ? value : (value - domain.lo) / domain.step);
}

/// The least width at which both can be compared, with a sign bit if either can be negative.
std::size_t BitBlaster::common_width(NodeId a, NodeId b) const {
  if (!either_signed(a, b)) return std::max(width(a), width(b));
  return std::max(width(a) + (is_signed(a) ? 0 : 1), width(b) + (is_signed(b) ? 0 : 1));
}

Literal BitBlaster::equality(NodeId a, NodeId b) {
  const std::size_t bits = common_width(a, b);
  return equal(circuit_, sized(a, bits), sized(b, bits));
}

Literal BitBlaster::comparison(NodeId a, NodeId b, bool or_equal) {
  const std::size_t bits = common_width(a, b);
  Bits x = sized(a, bits);
  Bits y = sized(b, bits);
  if (either_signed(a, b)) {  // a sign bit counts the other way round
    x.back() = !x.back();
    y.back() = !y.back();
  }
  return less(circuit_, x, y, or_equal);
}

Bits BitBlaster::extreme(NodeId a, NodeId b, bool smaller, std::size_t width) {
  const Literal first = comparison(a, b, true) ^ !smaller;
  return select(circuit_, first, sized(a, width), sized(b, width));
}

Bits BitBlaster::product(NodeId a, NodeId b, std::size_t width) {
  if (interval(a).single()) std::swap(a, b);
  if (interval(b).single()) return multiply(circuit_, sized(a, width), interval(b).lo);
  if (this->width(a) < this->width(b)) std::swap(a, b);
  return multiply(circuit_, sized(a, width), bits(b), is_signed(b));
}

/// Of two numbers that are not negative: floor(a / b) is ~floor(~a / b) for a negative a, as ~a is -a - 1;
/// and a negative divisor is made positive together with its dividend.
struct BitBlaster::FloorDivision {
  Literal dividend_sign, divisor_sign;
  Bits divisor;  // its absolute value
  Division division;
};

BitBlaster::FloorDivision BitBlaster::floor_divide(NodeId a, NodeId b) {
  FloorDivision made;
  made.divisor_sign = is_signed(b) ? bits(b).back() : kFalseLiteral;
  made.divisor = negate_if(circuit_, made.divisor_sign, bits(b));
  const std::size_t room = width(a) + (is_signed(a) ? 0 : 1) + (is_signed(b) ? 1 : 0);
  Bits dividend = sized(a, room);
  if (is_signed(b)) dividend = negate_if(circuit_, made.divisor_sign, dividend);
  made.dividend_sign = dividend.back();
  dividend.pop_back();
  made.division = divide(circuit_, exclusive_or(circuit_, dividend, made.dividend_sign), made.divisor);
  return made;
}

Bits BitBlaster::quotient(NodeId a, NodeId b, std::size_t width) {
  const std::int64_t divisor = interval(b).single() ? interval(b).lo : 0;
  if (divisor > 0 && std::has_single_bit(static_cast<std::uint64_t>(divisor))) {
    const int shift = std::countr_zero(static_cast<std::uint64_t>(divisor));
    Bits bits = sized(a, static_cast<std::size_t>(shift) + std::max(width, this->width(a)));
    bits.erase(bits.begin(), bits.begin() + shift);
    return resized(std::move(bits), width, is_signed(a));
  }
  const FloorDivision made = floor_divide(a, b);
  Bits bits = exclusive_or(circuit_, made.division.quotient, made.dividend_sign);
  bits.push_back(made.dividend_sign);
  return resized(std::move(bits), width, true);
}

/// Of a negative dividend it is divisor - 1 - remainder; and it has the divisor's sign.
Bits BitBlaster::modulus(NodeId a, NodeId b, std::size_t width) {
  const std::int64_t divisor = interval(b).single() ? interval(b).lo : 0;
  if (divisor > 0 && std::has_single_bit(static_cast<std::uint64_t>(divisor))) {
    const auto kept = static_cast<std::size_t>(std::countr_zero(static_cast<std::uint64_t>(divisor)));
    return resized(resized(sized(a, std::max(kept, this->width(a))), kept, false), width, false);
  }
  const FloorDivision made = floor_divide(a, b);
  Bits base = made.divisor;
  for (Literal& bit : base) bit = circuit_.conjunction(bit, made.dividend_sign);
  Bits bits = add(circuit_, base, exclusive_or(circuit_, made.division.remainder, made.dividend_sign));
  return negate_if(circuit_, made.divisor_sign, resized(std::move(bits), width, false));
}

}  // namespace solitaire
