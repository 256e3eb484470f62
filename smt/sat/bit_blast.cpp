#include "smt/sat/bit_blast.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "smt/operation_rows.h"
#include "smt/sat/constrained_sum.h"
#include "smt/sat/linear_comparison.h"
#include "smt/sat/truth_table.h"
#include "smt/tuning.h"
#include "smt/unsupported_operation.h"
#include "tracegraph/post_order.h"

namespace solitaire {

using BoolBlast = Literal (*)(BitBlaster&, const NodeId* operands);
using BitBlast = Bits (*)(BitBlaster&, std::size_t width, const NodeId* operands);
using OrderBlast = OrderEncodedInt (*)(BitBlaster&, const NodeId* operands);

/// What the bit-blaster knows about an operation. The functions get the operands; those of a leaf get the
/// leaf.
struct BitBlastRow {
  Op op;
  BoolBlast literal;           // makes the literal of a bool; an int has the members below
  BitBlast bits = nullptr;     // in binary
  OrderBlast order = nullptr;  // in order encoding, for operations that OrderSizes knows a size of
};

struct BitBlasts {
  using B = BitBlaster&;
  using N = const NodeId*;
  using W = std::size_t;

  // clang-format off
  static constexpr BitBlastRow kRows[] = {
      {Op::kConstBool, [](B b, N a) { return constant_literal(b.interval(*a).lo != 0); }},
      {Op::kConstInt, nullptr,
       [](B b, W w, N a) { return constant_bits(b.interval(*a).lo, w); },
       [](B b, N a) { return constant_order(b.interval(*a).lo); }},
      {Op::kChoice, nullptr,
       [](B b, W, N a) { return b.choices_.number(*a); },
       [](B b, N a) { return b.choice_order(*a); }},

      {Op::kNot, [](B b, N a) { return !b.literal(a[0]); }},
      {Op::kAnd, [](B b, N a) { return b.circuit_.conjunction(b.literal(a[0]), b.literal(a[1])); }},
      {Op::kOr, [](B b, N a) { return b.circuit_.disjunction(b.literal(a[0]), b.literal(a[1])); }},
      {Op::kEqBool, [](B b, N a) { return b.circuit_.equivalence(b.literal(a[0]), b.literal(a[1])); }},
      {Op::kIteBool, [](B b, N a) { return b.circuit_.mux(b.literal(a[0]), b.literal(a[1]), b.literal(a[2])); }},

      {Op::kAdd, nullptr,
       [](B b, W w, N a) { return add(b.circuit_, b.number(a[0]).sized(w), b.number(a[1]).sized(w)); },
       [](B b, N a) { return b.sum_order(*b.order(a[0]), *b.order(a[1])); }},
      {Op::kSub, nullptr,
       [](B b, W w, N a) { return subtract(b.circuit_, b.number(a[0]).sized(w), b.number(a[1]).sized(w)); },
       [](B b, N a) { return b.sum_order(*b.order(a[0]), negated(*b.order(a[1]))); }},
      {Op::kMul, nullptr,
       [](B b, W w, N a) { return product(b.circuit_, b.number(a[0]), b.number(a[1]), w); },
       [](B b, N a) {
         const bool first = b.interval(a[0]).single();
         return scaled(*b.order(a[first ? 1 : 0]), b.interval(a[first ? 0 : 1]).lo);
       }},
      {Op::kDiv, nullptr,
       [](B b, W w, N a) { return quotient(b.circuit_, b.number(a[0]), b.number(a[1]), w); },
       [](B b, N a) { return divided(*b.order(a[0]), b.interval(a[1]).lo); }},
      {Op::kMod, nullptr,
       [](B b, W w, N a) { return modulus(b.circuit_, b.number(a[0]), b.number(a[1]), w); }},
      {Op::kNeg, nullptr,
       [](B b, W w, N a) { return negate_if(b.circuit_, kTrueLiteral, b.number(a[0]).sized(w)); },
       [](B b, N a) { return negated(*b.order(a[0])); }},
      {Op::kMin, nullptr,
       [](B b, W w, N a) { return extreme(b.circuit_, b.number(a[0]), b.number(a[1]), true, w); },
       [](B b, N a) { return smaller(b.circuit_, *b.order(a[0]), *b.order(a[1])); }},
      {Op::kMax, nullptr,
       [](B b, W w, N a) { return extreme(b.circuit_, b.number(a[0]), b.number(a[1]), false, w); },
       [](B b, N a) { return larger(b.circuit_, *b.order(a[0]), *b.order(a[1])); }},
      {Op::kAbs, nullptr,
       [](B b, W w, N a) { return negate_if(b.circuit_, b.number(a[0]).bits.back(), b.number(a[0]).sized(w)); },
       [](B b, N a) { return larger(b.circuit_, *b.order(a[0]), negated(*b.order(a[0]))); }},
      {Op::kIteInt, nullptr,
       [](B b, W w, N a) { return select(b.circuit_, b.literal(a[0]), b.number(a[1]).sized(w), b.number(a[2]).sized(w)); },
       [](B b, N a) { return select(b.circuit_, b.literal(a[0]), *b.order(a[1]), *b.order(a[2])); }},

      {Op::kEqInt, [](B b, N a) { return b.equality(a[0], a[1]); }},
      {Op::kLtInt, [](B b, N a) { return b.comparison(a[0], a[1], false); }},
      {Op::kLeInt, [](B b, N a) { return b.comparison(a[0], a[1], true); }},
      {Op::kAllowed, [](B b, N a) { return b.allowed(a[0], a[1], *b.graph_.scalar(a[2]).table); }},
  };
  // clang-format on
};
static_assert(cover_all_operations(BitBlasts::kRows),
              "every operation that bits can express has its circuit");

namespace {

constexpr std::array<BitBlastRow, kOpCount> kBitBlasts = by_operation(BitBlasts::kRows);

const BitBlastRow& row_of(const Graph::Node& node) { return kBitBlasts[static_cast<std::size_t>(node.op)]; }

}  // namespace

Literal BitBlaster::condition(NodeId node) {
  compile({node, Form::kBits});
  return literal(node);
}

void BitBlaster::require(NodeId condition) {
  meet_new_nodes();
  std::vector<NodeId> pending{condition};
  while (!pending.empty()) {
    const NodeId at = pending.back();
    pending.pop_back();
    const Graph::Node& node = graph_.node(at);
    if (is_open(at) && node.op == Op::kAnd) {
      set_literal(at, kTrueLiteral);
      pending.insert(pending.end(), {node.operands[1], node.operands[0]});
    } else if (is_open(at) && is_difference_of_orders(at)) {
      set_literal(at, kTrueLiteral);
      require_different(node.operands[0]);
    } else {
      require_by_clause(at);
    }
  }
}

bool BitBlaster::is_open(NodeId condition) {
  return !is_compiled({condition, Form::kBits}) && small_cones_.tabled(condition).empty();
}

/// A disjunction is a clause of its two sides. What they consist of is left to `cnf_`, since other conditions
/// may have parts of it as well, for which they share a variable then.
void BitBlaster::require_by_clause(NodeId condition) {
  const bool is_new = is_open(condition);
  const bool is_negation = graph_.node(condition).op == Op::kNot;
  const NodeId whole = is_negation ? graph_.node(condition).operands[0] : condition;
  const Graph::Node& node = graph_.node(whole);
  std::vector<Literal> literals;
  if (is_new && is_open(whole) && node.op == (is_negation ? Op::kAnd : Op::kOr)) {
    const auto [a, b, unused] = node.operands;
    add_alternatives(a, !is_negation, literals);
    add_alternatives(b, !is_negation, literals);
    set_literal(condition, kTrueLiteral);
  } else {
    add_alternatives(condition, literals);
  }
  cnf_.add_clause(literals);
}

/// Returns true if the condition is that two ints differ which both are written in order encoding, and not
/// constant, and nobody has asked yet whether they are equal.
bool BitBlaster::is_difference_of_orders(NodeId condition) {
  const Graph::Node& negation = graph_.node(condition);
  if (negation.op != Op::kNot || is_compiled({negation.operands[0], Form::kBits})) return false;
  const Graph::Node& equation = graph_.node(negation.operands[0]);
  const auto [a, b, unused] = equation.operands;
  return equation.op == Op::kEqInt && !graph_.node(b).is_constant() && order_sizes_.are_ordered(a, b) &&
         linear_form(a, b) == nullptr;
}

void BitBlaster::require_different(NodeId equation) {
  const auto [a, b, unused] = graph_.node(equation).operands;
  compile({a, Form::kOrder});
  compile({b, Form::kOrder});
  set_literal(equation, kFalseLiteral);
  if (order(a)->size() == 1 || order(b)->size() == 1) {
    const Literal differ = !equal(circuit_, order(a), order(b));
    return cnf_.add_clause({&differ, 1});
  }
  use(circuit_, *order(a));
  use(circuit_, *order(b));
  cnf_.require_different(*order(a), *order(b));
}

void BitBlaster::add_alternatives(NodeId condition, bool holds, std::vector<Literal>& literals) {
  const Graph::Node& node = graph_.node(condition);
  if (node.op == Op::kNot && is_choice_of_value(node.operands[0]))
    return add_alternatives(node.operands[0], !holds, literals);
  if (!holds && is_choice_of_value(condition))
    return add_other_values(graph_.node(node.operands[0]).payload, interval(node.operands[1]).lo, literals);
  literals.push_back(this->condition(condition) ^ !holds);
}

bool BitBlaster::is_choice_of_value(NodeId condition) const {
  const Graph::Node& node = graph_.node(condition);
  return node.op == Op::kEqInt && graph_.node(node.operands[0]).op == Op::kChoice &&
         graph_.node(node.operands[1]).is_constant();
}

/// Appends literals one of which holds where the choice has another value.
void BitBlaster::add_other_values(std::size_t variable, std::int64_t value, std::vector<Literal>& literals) {
  choices_.add(variable);
  if (const OrderEncodedInt* order = choices_.order(variable)) {
    literals.insert(literals.end(), {!order->at_least(value), order->more_than(value)});
    return;
  }
  const Bits& bits = choices_.bits(variable);
  for (std::size_t i = 0; i < bits.size(); ++i)
    literals.push_back(bits[i] ^ choices_.input_at(variable, i, value));
}

void BitBlaster::compile(Part part) {
  meet_new_nodes();
  const auto push_needed = [this](Part at, std::vector<Part>& pending) {
    require_bits(graph_, at.node);
    push_operands(at, pending);
  };
  in_post_order(
      part, [this](Part at) { return is_compiled(at); }, push_needed, [this](Part at) { compile_one(at); });
}

void BitBlaster::meet_new_nodes() {
  compiled_.resize(graph_.size());
  if (order_sizes_.meet_new_nodes())
    small_cones_.meet_new([this](NodeId node) { return order_sizes_.of(node).is_ordered(); });
}

bool BitBlaster::is_compiled(Part part) const {
  const Compiled& compiled = compiled_[part.node.index];
  return (part.form == Form::kOrder ? compiled.order : compiled.bits) != 0;
}

void BitBlaster::push_operands(Part part, std::vector<Part>& pending) {
  const auto push = [&](Part needed) {
    if (!is_compiled(needed)) pending.push_back(needed);
  };
  const Graph::Node& node = graph_.node(part.node);
  const std::span<const NodeId> choices = small_cones_.tabled(part.node);
  if (!choices.empty()) {
    for (const NodeId choice : choices) push({choice, Form::kOrder});
    return;
  }
  const bool compares =
      node.type() == Type::kBool && !node.args().empty() && is_int(node.operands[0]) && !has_table(node.op);
  if (const LinearForm* form = compares ? linear_form(node.operands[0], node.operands[1]) : nullptr) {
    for (const auto& [term, factor] : form->terms) push({term, Form::kOrder});
    return;
  }
  const Form form = form_of_operands(part);
  for (const NodeId operand : node.args()) {
    if (graph_.node(operand).op != Op::kConstTable) push({operand, is_int(operand) ? form : Form::kBits});
  }
}

/// Returns b - a as a sum of ints in order encoding, or null if it is to be compared in another way.
const LinearForm* BitBlaster::linear_form(NodeId a, NodeId b) {
  if (!may_have_form(graph_, a, b)) return nullptr;
  const auto [entry, is_new] = linear_forms_.try_emplace(std::uint64_t{a.index} << 32 | b.index);
  if (is_new)
    entry->second =
        ordered_difference_form(graph_, a, b, [this](NodeId node) { return order_sizes_.of(node); });
  return entry->second ? &*entry->second : nullptr;
}

BitBlaster::Form BitBlaster::form_of_operands(Part part) const {
  const Graph::Node& node = graph_.node(part.node);
  if (node.type() != Type::kBool || node.args().empty()) return part.form;
  return order_sizes_.are_ordered(node.operands[0], node.operands[1]) ? Form::kOrder : Form::kBits;
}

void BitBlaster::compile_one(Part part) {
  const Graph::Node& node = graph_.node(part.node);
  const BitBlastRow& row = row_of(node);
  const NodeId* operands = operands_or_itself(node, part.node);
  Compiled& compiled = compiled_[part.node.index];
  if (part.form == Form::kOrder) {
    orders_.push_back(std::make_shared<OrderEncodedInt>(row.order(*this, operands)));
    compiled.order = static_cast<std::uint32_t>(orders_.size());
  } else if (const std::span<const NodeId> choices = small_cones_.tabled(part.node); !choices.empty()) {
    compiled.bits = table(part.node, choices).code() + 1;
  } else if (row.literal != nullptr) {
    compiled.bits = row.literal(*this, operands).code() + 1;
  } else {
    const auto width = static_cast<std::size_t>(bit_width(node.interval));
    numbers_.push_back(with_known_bits(row.bits(*this, width, operands), node.interval));
    compiled.bits = static_cast<std::uint32_t>(numbers_.size());
  }
}

OrderEncodedInt BitBlaster::sum_order(const OrderEncodedInt& a, const OrderEncodedInt& b) {
  return a.size() * b.size() > tuning::kMostOrderedSum ? constrained_sum(circuit_, cnf_, a, b)
                                                       : sum(circuit_, a, b);
}

OrderEncodedInt BitBlaster::choice_order(NodeId choice) {
  const std::size_t variable = graph_.node(choice).payload;
  choices_.add(variable);
  return *choices_.order(variable);
}

Literal BitBlaster::table(NodeId condition, std::span<const NodeId> choices) {
  TruthTable table(graph_, condition, choices);
  if (choices.size() == 1) return tabled(circuit_, table, *order(choices[0]));
  return tabled(circuit_, std::move(table), order(choices[0]), order(choices[1]));
}

Literal BitBlaster::allowed(NodeId a, NodeId b, const PairTable& pairs) {
  if (order_sizes_.are_ordered(a, b))
    return tabled(circuit_, TruthTable(pairs, *order(a), *order(b)), order(a), order(b));
  Literal any = kFalseLiteral;
  for (std::size_t row = 0; row < pairs.rows(); ++row) {
    Literal other = kFalseLiteral;
    for (std::size_t column = 0; column < pairs.columns(); ++column) {
      if (pairs.allows(static_cast<std::int64_t>(row), static_cast<std::int64_t>(column)))
        other = circuit_.disjunction(other, has_value(b, column));
    }
    any = circuit_.disjunction(any, circuit_.conjunction(has_value(a, row), other));
  }
  return any;
}

/// Of an int in bits.
Literal BitBlaster::has_value(NodeId node, std::size_t value) {
  const auto constant = static_cast<std::int64_t>(value);
  if (!interval(node).contains(constant)) return kFalseLiteral;
  return equal(circuit_, number(node).bits, constant_bits(constant, number(node).width()));
}

Literal BitBlaster::equality(NodeId a, NodeId b) {
  if (const LinearForm* form = linear_form(a, b)) {
    if (const auto digits = equal_digits(graph_, *form)) return all_equal(*digits);
    return circuit_.conjunction(linear_less(a, b, true, *form), !linear_less(a, b, false, *form));
  }
  if (order_sizes_.are_ordered(a, b)) return equal(circuit_, order(a), order(b));
  return equal(circuit_, number(a), number(b));
}

Literal BitBlaster::all_equal(const std::vector<ShiftedEquality>& equalities) {
  Literal all = kTrueLiteral;
  for (const auto& [a, b, shift] : equalities) {
    if (shift != 0) {
      const auto moved = std::make_shared<OrderEncodedInt>(sum(circuit_, *order(b), constant_order(shift)));
      all = circuit_.conjunction(all, equal(circuit_, order(a), moved));
      continue;
    }
    const auto key = std::minmax(a.index, b.index);
    const auto [entry, is_new] = equal_ints_.try_emplace(std::uint64_t{key.first} << 32 | key.second);
    if (is_new) entry->second = equal(circuit_, order(a), order(b));
    all = circuit_.conjunction(all, entry->second);
  }
  return all;
}

Literal BitBlaster::comparison(NodeId a, NodeId b, bool or_equal) {
  if (const LinearForm* form = linear_form(a, b)) return linear_less(a, b, or_equal, *form);
  if (order_sizes_.are_ordered(a, b)) return less(circuit_, order(a), order(b), or_equal);
  return less(circuit_, number(a), number(b), or_equal);
}

Literal BitBlaster::linear_less(NodeId a, NodeId b, bool or_equal, const LinearForm& form) {
  std::vector<ScaledOrder> terms;
  for (const auto& [term, factor] : form.terms) terms.push_back({order(term), factor});
  return linear_comparison(circuit_, std::move(terms), (or_equal ? 0 : 1) - form.constant,
                           [=, this] { return comparison_in_gates(a, b, or_equal); });
}

Literal BitBlaster::comparison_in_gates(NodeId a, NodeId b, bool or_equal) {
  const Form form = order_sizes_.are_ordered(a, b) ? Form::kOrder : Form::kBits;
  compile({a, form});
  compile({b, form});
  if (form == Form::kOrder) return less(circuit_, order(a), order(b), or_equal);
  return less(circuit_, number(a), number(b), or_equal);
}

}  // namespace solitaire
