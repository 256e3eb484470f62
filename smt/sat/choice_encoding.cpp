#include "smt/sat/choice_encoding.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace solitaire {

Bits with_known_bits(Bits bits, Interval interval) {
  const auto differing = static_cast<std::uint64_t>(interval.lo ^ interval.hi);
  for (auto i = static_cast<std::size_t>(std::bit_width(differing)); i < bits.size(); ++i) {
    bits[i] = constant_literal(((interval.lo >> i) & 1) != 0);
  }
  return bits;
}

/// Returns the interval of the numbers that the bits of a variable stand for.
Interval ChoiceEncoding::numbers(std::size_t variable) const {
  const Distribution& values = domain(variable);
  return values.step == 1 ? Interval{values.lo, values.hi}
                          : Interval{0, (values.hi - values.lo) / values.step};
}

void ChoiceEncoding::write_in_bits(std::size_t variable) {
  if (choices_.size() <= variable) choices_.resize(graph_.variables().size());
  if (choices_[variable].inputs.empty()) choices_[variable].without_order = true;
}

OrderSize ChoiceEncoding::order_size(std::size_t variable) const {
  if (variable < choices_.size() && choices_[variable].without_order) return {};
  const Distribution& values = domain(variable);
  return size_within(values.interval(), UINT64_MAX, static_cast<std::uint64_t>(values.step));
}

void ChoiceEncoding::add(std::size_t variable) {
  if (choices_.size() <= variable) choices_.resize(graph_.variables().size());
  Choice& made = choices_[variable];
  if (!made.inputs.empty()) return;
  if (order_size(variable).is_ordered()) {
    made.order = ordered_input(domain(variable), made.inputs);
  } else {
    made.bits = made.inputs = bounded_input(numbers(variable));
  }
}

/// An int that reaches a value reaches all lower ones. One clause for each two neighbours says so.
OrderEncodedInt ChoiceEncoding::ordered_input(const Distribution& domain, Bits& inputs) {
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

Bits ChoiceEncoding::bounded_input(Interval interval) {
  Bits bits(static_cast<std::size_t>(bit_width(interval)));
  for (Literal& bit : bits) bit = circuit_.input();
  bits = with_known_bits(std::move(bits), interval);
  Bits lo = constant_bits(interval.lo, bits.size());
  Bits hi = constant_bits(interval.hi, bits.size());
  Bits offset = bits;
  if (interval.lo < 0) {  // with inverted sign bits, signed numbers compare like unsigned ones
    for (Bits* each : {&lo, &hi, &offset}) each->back() = !each->back();
  }
  for (const Literal bound : {less(circuit_, lo, offset, true), less(circuit_, offset, hi, true)}) {
    cnf_.add_clause({&bound, 1});
  }
  return bits;
}

std::span<const Literal> ChoiceEncoding::inputs(std::size_t variable) const {
  if (variable >= choices_.size()) return {};
  return choices_[variable].inputs;
}

const OrderEncodedInt* ChoiceEncoding::order(std::size_t variable) const {
  const auto& order = choices_[variable].order;
  return order ? &*order : nullptr;
}

const Bits& ChoiceEncoding::bits(std::size_t variable) {
  Choice& made = choices_[variable];
  if (made.bits.empty()) made.bits = bits_of_order(variable, *made.order);
  return made.bits;
}

/// Makes the bits of a choice in order encoding. Each bit holds in some runs of neighbouring values.
Bits ChoiceEncoding::bits_of_order(std::size_t variable, const OrderEncodedInt& order) {
  Bits bits(static_cast<std::size_t>(bit_width(numbers(variable))), kFalseLiteral);
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

Bits ChoiceEncoding::number(NodeId choice) {
  const std::size_t variable = graph_.node(choice).payload;
  const std::int64_t step = domain(variable).step;
  add(variable);
  if (step == 1) return bits(variable);
  const Interval values = graph_.node(choice).interval;
  const auto width = static_cast<std::size_t>(bit_width(values));
  const Bits steps = resized(bits(variable), width, false);
  return solitaire::add(circuit_, multiply(circuit_, steps, step), constant_bits(values.lo, width));
}

bool ChoiceEncoding::input_at(std::size_t variable, std::size_t input, std::int64_t value) const {
  if (choices_[variable].order) return choices_[variable].order->values[input + 1] <= value;
  return ((bits_of(variable, value) >> input) & 1) != 0;
}

std::int64_t ChoiceEncoding::decode(std::size_t variable, const std::function<bool(Literal)>& holds) const {
  const Choice& made = choices_[variable];
  if (made.order) {
    const auto reached = std::partition_point(made.inputs.begin(), made.inputs.end(), holds);
    return made.order->values[static_cast<std::size_t>(reached - made.inputs.begin())];
  }
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < made.bits.size(); ++i) bits |= std::uint64_t{holds(made.bits[i])} << i;
  return decode(variable, bits);
}

std::int64_t ChoiceEncoding::decode(std::size_t variable, std::uint64_t bits) const {
  const Distribution& values = domain(variable);
  if (values.step != 1) return values.lo + static_cast<std::int64_t>(bits) * values.step;
  if (values.lo >= 0) return static_cast<std::int64_t>(bits);
  const int unused = 64 - bit_width({values.lo, values.hi});
  return static_cast<std::int64_t>(bits << unused) >> unused;
}

std::uint64_t ChoiceEncoding::bits_of(std::size_t variable, std::int64_t value) const {
  const Distribution& values = domain(variable);
  return static_cast<std::uint64_t>(values.step == 1 ? value : (value - values.lo) / values.step);
}

}  // namespace solitaire
