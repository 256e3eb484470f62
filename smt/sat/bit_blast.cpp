#include "smt/sat/bit_blast.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "smt/operation_rows.h"
#include "smt/tuning.h"
#include "smt/unsupported_operation.h"

namespace solitaire {
/// The column of the operation table that says how each operation becomes a circuit.
struct BitBlasts {
  using B = BitBlaster&;
  using N = const NodeId*;
  using W = std::size_t;  // the width of an int result
  using BoolBlast = Literal (*)(BitBlaster&, const NodeId* operands);
  using BitBlast = Bits (*)(BitBlaster&, std::size_t width, const NodeId* operands);
  using OrderBlast = OrderEncodedInt (*)(BitBlaster&, const NodeId* operands);

  struct Row {
    Op op;
    BoolBlast literal;  // of bools; of ints, the others
    BitBlast bits;
    OrderBlast order;
  };

  static constexpr Row kRows[] = {
      {Op::kConstBool, [](B b, N a) { return constant_literal(b.interval(*a).lo != 0); }, nullptr, nullptr},
      {Op::kConstInt, nullptr, [](B b, W w, N a) { return constant_bits(b.interval(*a).lo, w); },
       [](B b, N a) { return constant_order(b.interval(*a).lo); }},
      {Op::kChoice, nullptr, [](B b, W, N a) { return b.choice_number(*a); },
       [](B b, N a) { return *b.choice(b.graph_.node(*a).payload).order; }},

      {Op::kNot, [](B b, N a) { return !b.literal(a[0]); }, nullptr, nullptr},
      {Op::kAnd, [](B b, N a) { return b.circuit_.conjunction(b.literal(a[0]), b.literal(a[1])); }, nullptr,
       nullptr},
      {Op::kOr, [](B b, N a) { return b.circuit_.disjunction(b.literal(a[0]), b.literal(a[1])); }, nullptr,
       nullptr},
      {Op::kEqBool, [](B b, N a) { return b.circuit_.equivalence(b.literal(a[0]), b.literal(a[1])); },
       nullptr, nullptr},
      {Op::kIteBool,
       [](B b, N a) { return b.circuit_.mux(b.literal(a[0]), b.literal(a[1]), b.literal(a[2])); }, nullptr,
       nullptr},

      {Op::kAdd, nullptr, [](B b, W w, N a) { return add(b.circuit_, b.sized(a[0], w), b.sized(a[1], w)); },
       [](B b, N a) { return sum(b.circuit_, b.order(a[0]), b.order(a[1])); }},
      {Op::kSub, nullptr,
       [](B b, W w, N a) { return subtract(b.circuit_, b.sized(a[0], w), b.sized(a[1], w)); },
       [](B b, N a) { return sum(b.circuit_, b.order(a[0]), negated(b.order(a[1]))); }},
      {Op::kMul, nullptr, [](B b, W w, N a) { return b.product(a[0], a[1], w); },
       [](B b, N a) {
         const bool first = b.interval(a[0]).single();
         return scaled(b.order(a[first ? 1 : 0]), b.interval(a[first ? 0 : 1]).lo);
       }},
      {Op::kDiv, nullptr, [](B b, W w, N a) { return b.quotient(a[0], a[1], w); },
       [](B b, N a) { return divided(b.order(a[0]), b.interval(a[1]).lo); }},
      {Op::kMod, nullptr, [](B b, W w, N a) { return b.modulus(a[0], a[1], w); }, nullptr},
      {Op::kNeg, nullptr, [](B b, W w, N a) { return negate_if(b.circuit_, kTrueLiteral, b.sized(a[0], w)); },
       [](B b, N a) { return negated(b.order(a[0])); }},
      {Op::kMin, nullptr, [](B b, W w, N a) { return b.extreme(a[0], a[1], true, w); },
       [](B b, N a) { return smaller(b.circuit_, b.order(a[0]), b.order(a[1])); }},
      {Op::kMax, nullptr, [](B b, W w, N a) { return b.extreme(a[0], a[1], false, w); },
       [](B b, N a) { return larger(b.circuit_, b.order(a[0]), b.order(a[1])); }},
      {Op::kAbs, nullptr,
       [](B b, W w, N a) { return negate_if(b.circuit_, b.bits(a[0]).back(), b.sized(a[0], w)); },
       [](B b, N a) { return larger(b.circuit_, b.order(a[0]), negated(b.order(a[0]))); }},
      {Op::kIteInt, nullptr,
       [](B b, W w, N a) { return select(b.circuit_, b.literal(a[0]), b.sized(a[1], w), b.sized(a[2], w)); },
       [](B b, N a) { return select(b.circuit_, b.literal(a[0]), b.order(a[1]), b.order(a[2])); }},

      {Op::kEqInt, [](B b, N a) { return b.equality(a[0], a[1]); }, nullptr, nullptr},
      {Op::kLtInt, [](B b, N a) { return b.comparison(a[0], a[1], false); }, nullptr, nullptr},
      {Op::kLeInt, [](B b, N a) { return b.comparison(a[0], a[1], true); }, nullptr, nullptr},
  };
};
static_assert(cover_all_operations(BitBlasts::kRows),
              "every operation that bits can express has its circuit");

namespace {

constexpr std::array<BitBlasts::Row, kOpCount> kBlasts = by_operation(BitBlasts::kRows);

}  // namespace

Literal BitBlaster::condition(NodeId node) {
  compile({node, Form::kBits});
  return literal(node);
}

void BitBlaster::add_alternatives(NodeId condition, std::vector<Literal>& literals) {
  const Graph::Node& negation = graph_.node(condition);
  const Graph::Node& equality = graph_.node(negation.operands[0]);
  const auto [choice_node, constant, unused] = equality.operands;
  if (negation.op != Op::kNot || equality.op != Op::kEqInt || graph_.node(choice_node).op != Op::kChoice ||
      !graph_.node(constant).is_constant()) {
    literals.push_back(this->condition(condition));
    return;
  }
  const std::size_t variable = graph_.node(choice_node).payload;
  const std::int64_t value = interval(constant).lo;
  const Choice& made = choice(variable);
  if (made.order) {
    literals.insert(literals.end(), {!made.order->at_least(value), made.order->more_than(value)});
    return;
  }
  for (std::size_t i = 0; i < made.bits.size(); ++i)
    literals.push_back(made.bits[i] ^ input_at(variable, i, value));
}

/// Operands first, on an own stack: the graph can be deeper than the machine's.
void BitBlaster::compile(Part part) {
  compiled_.resize(graph_.size());
  const auto met = static_cast<std::uint32_t>(order_sizes_.size());
  order_sizes_.resize(graph_.size());
  for (std::uint32_t node = met; node < graph_.size(); ++node) order_sizes_[node] = order_size({node});
  std::vector<Part> pending{part};
  while (!pending.empty()) {
    const Part at = pending.back();
    const std::size_t waiting = pending.size();
    if (!is_compiled(at)) {
      require_bits(graph_, at.node);
      push_operands(at, pending);
      if (pending.size() > waiting) continue;
      compile_one(at);
    }
    pending.pop_back();
  }
}

bool BitBlaster::is_compiled(Part part) const {
  const Compiled& compiled = compiled_[part.node.index];
  return (part.form == Form::kOrder ? compiled.order : compiled.bits) != 0;
}

void BitBlaster::push_operands(Part part, std::vector<Part>& pending) {
  const Form form = form_of_operands(part);
  for (const NodeId operand : graph_.node(part.node).args()) {
    const bool is_int = graph_.node(operand).type() == Type::kInt;
    const Part needed{operand, is_int ? form : Form::kBits};
    if (!is_compiled(needed)) pending.push_back(needed);
  }
}

BitBlaster::Form BitBlaster::form_of_operands(Part part) const {
  const Graph::Node& node = graph_.node(part.node);
  if (node.type() != Type::kBool || node.args().empty()) return part.form;
  return comparable_in_order(node.operands[0], node.operands[1]) ? Form::kOrder : Form::kBits;
}

bool BitBlaster::comparable_in_order(NodeId a, NodeId b) const {
  return order_sizes_[a.index].most > 0 && order_sizes_[b.index].most > 0;
}

void BitBlaster::compile_one(Part part) {
  const Graph::Node& node = graph_.node(part.node);
  const BitBlasts::Row& row = kBlasts[static_cast<std::size_t>(node.op)];
  const NodeId* operands = operation(node.op).arity == 0 ? &part.node : node.operands.data();
  Compiled& compiled = compiled_[part.node.index];
  if (part.form == Form::kOrder) {
    orders_.push_back(std::make_shared<OrderEncodedInt>(row.order(*this, operands)));
    compiled.order = static_cast<std::uint32_t>(orders_.size());
  } else if (row.literal != nullptr) {
    compiled.bits = row.literal(*this, operands).code() + 1;
  } else {
    const auto width = static_cast<std::size_t>(bit_width(node.interval));
    numbers_.push_back(with_known_bits(row.bits(*this, width, operands), node.interval));
    compiled.bits = static_cast<std::uint32_t>(numbers_.size());
  }
}

/// How many values the node's order would have, at most; 0 if it has none, or too many of them.
BitBlaster::OrderSize BitBlaster::order_size(NodeId id) const {
  const Graph::Node& node = graph_.node(id);
  if (node.type() != Type::kInt || kBlasts[static_cast<std::size_t>(node.op)].order == nullptr) return {};
  if (node.is_constant()) return {1, 0};
  std::array<OrderSize, 3> of;
  for (std::size_t i = 0; i < node.args().size(); ++i) of[i] = order_sizes_[node.operands[i].index];
  const auto [a, b, c] = of;
  const auto size = [&](std::uint64_t most, std::uint64_t stride) -> OrderSize {
    const auto span = static_cast<std::uint64_t>(node.interval.hi - node.interval.lo);
    most = std::min(most, span / std::max<std::uint64_t>(stride, 1) + 1);
    return most <= tuning::kMostOrdered ? OrderSize{most, stride} : OrderSize{};
  };
  const auto either = [&](const OrderSize& x, const OrderSize& y, NodeId first, NodeId second) {
    if (x.most == 0 || y.most == 0) return OrderSize{};
    const auto offset = static_cast<std::uint64_t>(std::abs(interval(first).lo - interval(second).lo));
    return size(x.most + y.most, std::gcd(std::gcd(x.stride, y.stride), offset));
  };
  switch (node.op) {
    case Op::kChoice: {
      const auto step = static_cast<std::uint64_t>(graph_.variable(id).domain.step);
      return size(UINT64_MAX, step);
    }
    case Op::kAdd:
    case Op::kSub:
      if (a.most * b.most == 0 || a.most * b.most > tuning::kMostOrderedSum) return {};
      return size(a.most * b.most, std::gcd(a.stride, b.stride));
    case Op::kMul: {
      const bool first = interval(node.operands[0]).single();
      if (a.most * b.most == 0 || !interval(node.operands[first ? 0 : 1]).single()) return {};
      return size(a.most * b.most, 1);
    }
    case Op::kDiv:
      if (b.most == 0 || !interval(node.operands[1]).single() || interval(node.operands[1]).lo <= 0)
        return {};
      return size(a.most, 1);
    case Op::kNeg:
      return size(a.most, a.stride);
    case Op::kMin:
    case Op::kMax:
      return either(a, b, node.operands[0], node.operands[1]);
    case Op::kIteInt:
      return either(b, c, node.operands[1], node.operands[2]);
    case Op::kAbs:
      return size(2 * a.most, 1);
    default:
      return {};
  }
}

/// Upper bits that all values of the interval have in common are constants.
Bits BitBlaster::with_known_bits(Bits bits, Interval interval) const {
  const auto differing = static_cast<std::uint64_t>(interval.lo ^ interval.hi);
  for (auto i = static_cast<std::size_t>(std::bit_width(differing)); i < bits.size(); ++i) {
    bits[i] = constant_literal(((interval.lo >> i) & 1) != 0);
  }
  return bits;
}

BitBlaster::Choice& BitBlaster::choice(std::size_t variable) {
  if (choices_.size() <= variable) choices_.resize(graph_.variables().size());
  Choice& made = choices_[variable];
  if (!made.inputs.empty()) return made;
  const Distribution& domain = graph_.variables()[variable].domain;
  const Interval steps{0, (domain.hi - domain.lo) / domain.step};
  if (static_cast<std::uint64_t>(steps.hi) < tuning::kMostOrdered) {
    made.order = ordered_input(domain, made.inputs);
  } else {
    made.bits = made.inputs = bounded_input(domain.step == 1 ? Interval{domain.lo, domain.hi} : steps);
  }
  return made;
}

OrderEncodedInt BitBlaster::ordered_input(const Distribution& domain, Bits& inputs) {
  OrderEncodedInt order = constant_order(domain.lo);
  for (std::int64_t value = domain.lo + domain.step; value <= domain.hi; value += domain.step) {
    order.values.push_back(value);
    order.reached.push_back(circuit_.input());
    if (order.reached.size() == 1) continue;
    const Literal reached_before[] = {!order.reached.back(), order.reached.end()[-2]};
    cnf_.add_clause(reached_before);
  }
  inputs = order.reached;
  return order;
}

Bits BitBlaster::choice_bits(std::size_t variable) {
  if (choice_inputs(variable).empty()) return {};
  Choice& made = choices_[variable];
  if (made.bits.empty()) made.bits = bits_of_order(variable, *made.order);
  return made.bits;
}

/// Each bit holds in some runs of neighbouring values.
Bits BitBlaster::bits_of_order(std::size_t variable, const OrderEncodedInt& order) {
  const Distribution& domain = graph_.variables()[variable].domain;
  const Interval numbers =
      domain.step == 1 ? Interval{domain.lo, domain.hi} : Interval{0, (domain.hi - domain.lo) / domain.step};
  Bits bits(static_cast<std::size_t>(bit_width(numbers)), kFalseLiteral);
  for (std::size_t i = 0; i < bits.size(); ++i) {
    bool holds = false;
    Literal start;
    for (const std::int64_t value : order.values) {
      if ((((bits_of(variable, value) >> i) & 1) != 0) == holds) continue;
      holds = !holds;
      if (holds) {
        start = order.at_least(value);
      } else {
        bits[i] = circuit_.disjunction(bits[i], circuit_.conjunction(start, !order.at_least(value)));
      }
    }
    if (holds) bits[i] = circuit_.disjunction(bits[i], start);
  }
  return bits;
}

/// A choice of step 1 is its bits; one of a larger step counts its steps from the lower end.
Bits BitBlaster::choice_number(NodeId id) {
  const std::size_t variable = graph_.node(id).payload;
  const Interval values = interval(id);
  choice(variable);
  Bits bits = choice_bits(variable);
  if (graph_.variable(id).domain.step == 1) return bits;
  const auto width = static_cast<std::size_t>(bit_width(values));
  return add(circuit_,
             multiply(circuit_, resized(std::move(bits), width, false), graph_.variable(id).domain.step),
             constant_bits(values.lo, width));
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

std::span<const Literal> BitBlaster::choice_inputs(std::size_t variable) const {
  if (variable >= choices_.size()) return {};
  return choices_[variable].inputs;
}

bool BitBlaster::input_at(std::size_t variable, std::size_t input, std::int64_t value) const {
  if (choices_[variable].order) return choices_[variable].order->values[input + 1] <= value;
  return ((bits_of(variable, value) >> input) & 1) != 0;
}

std::int64_t BitBlaster::decode(std::size_t variable, const std::function<bool(Literal)>& holds) const {
  const Choice& made = choices_[variable];
  if (made.order) {
    const auto reached =
        static_cast<std::size_t>(std::count_if(made.inputs.begin(), made.inputs.end(), holds));
    return made.order->values[reached];
  }
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < made.bits.size(); ++i) bits |= std::uint64_t{holds(made.bits[i])} << i;
  return decode(variable, bits);
}

std::int64_t BitBlaster::decode(std::size_t variable, std::uint64_t bits) const {
  const Distribution& domain = graph_.variables()[variable].domain;
  if (domain.step != 1) return domain.lo + static_cast<std::int64_t>(bits) * domain.step;
  if (domain.lo >= 0) return static_cast<std::int64_t>(bits);
  const int unused = 64 - bit_width({domain.lo, domain.hi});
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

std::uint64_t BitBlaster::bits_of(std::size_t variable, std::int64_t value) const {
  const Distribution& domain = graph_.variables()[variable].domain;
  return static_cast<std::uint64_t>(domain.step == 1 ? value : (value - domain.lo) / domain.step);
}

/// The least width at which both can be compared, with a sign bit if either can be negative.
std::size_t BitBlaster::common_width(NodeId a, NodeId b) const {
  if (!either_signed(a, b)) return std::max(width(a), width(b));
  return std::max(width(a) + (is_signed(a) ? 0 : 1), width(b) + (is_signed(b) ? 0 : 1));
}

Literal BitBlaster::equality(NodeId a, NodeId b) {
  if (comparable_in_order(a, b)) return equal(circuit_, shared_order(a), shared_order(b));
  const std::size_t bits = common_width(a, b);
  return equal(circuit_, sized(a, bits), sized(b, bits));
}

Literal BitBlaster::comparison(NodeId a, NodeId b, bool or_equal) {
  if (comparable_in_order(a, b)) return less(circuit_, shared_order(a), shared_order(b), or_equal);
  return bit_comparison(a, b, or_equal);
}

Literal BitBlaster::bit_comparison(NodeId a, NodeId b, bool or_equal) {
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
  const Literal first = bit_comparison(a, b, true) ^ !smaller;
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
