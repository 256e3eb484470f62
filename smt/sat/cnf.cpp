#include "smt/sat/cnf.h"

#include <algorithm>
#include <utility>

#include "smt/sat/order_encoded_int.h"
#include "smt/tuning.h"

namespace solitaire {

void ClauseSink::order_difference(const OrderDifference& difference) {
  std::vector<int> literals;
  const auto add_other = [&](const std::vector<int>& chain, std::uint32_t at) {
    if (at > 0) literals.push_back(-chain[at - 1]);
    if (at < chain.size()) literals.push_back(chain[at]);
  };
  for (std::uint32_t i = 0; i < difference.count; ++i) {
    literals.assign(difference.guard != 0 ? 1 : 0, -difference.guard);
    add_other(*difference.a, difference.first + i);
    add_other(*difference.b, difference.base + i);
    clause(literals);
  }
}

void ClauseSink::order_implication(const OrderImplication& order_implication) {
  for (std::uint32_t i = 0; i < order_implication.count; ++i) {
    const int literals[] = {-order_implication.guard,
                            -(*order_implication.lower)[order_implication.first + i],
                            (*order_implication.upper)[order_implication.base + i]};
    clause(literals);
  }
}

void Cnf::add_clause(std::span<const Literal> literals) {
  for (const Literal literal : literals) circuit_.use(literal);
  push({0, literals});
  write_all();
}

void Cnf::require_different(const OrderEncodedInt& a, const OrderEncodedInt& b) {
  write_difference(0, {&a, &b, OrderedPair::Relation::kDifferent});
  write_all();
}

int Cnf::assumable(Literal literal) {
  circuit_.use(literal);
  const bool fixed = is_constant(literal) && !has_number(literal);
  const int number = demand(literal);
  if (fixed) {
    const int truth[] = {literal == kTrueLiteral ? number : -number};
    sink_.clause(truth);
  }
  write_all();
  return number;
}

int Cnf::equivalent(Literal literal) {
  assumable(!literal);
  return assumable(literal);
}

int Cnf::known_variable(Literal input) const { return has_number(input) ? numbers_[input.gate()] : 0; }

void Cnf::write_linear_as_clauses() {
  for (const auto& [head, definition, negated] : std::exchange(postponed_, {})) {
    const Clause rest{head, {}};
    definition->write(negated, [&](std::span<const Literal> literals) { push_clause(rest, literals); });
  }
  write_all();
}

/// Clauses make definitions necessary, and definitions make clauses. Both wait on stacks of this class, as
/// circuits can be deeper than the machine's stack.
void Cnf::write_all() {
  if (std::exchange(is_writing_, true)) return;  // a definition asks for clauses, which come in their turn
  while (true) {
    if (!clauses_.empty()) {
      write(pop());
    } else if (!definitions_.empty()) {
      const Literal literal = definitions_.back();
      definitions_.pop_back();
      define(literal);
    } else {
      is_writing_ = false;
      return;
    }
  }
}

void Cnf::push(const Clause& clause) {
  clauses_.push_back({clause.head, literals_.size()});
  literals_.insert(literals_.end(), clause.literals.begin(), clause.literals.end());
}

/// Takes the clause that was pushed last off the stack and into popped_. Returns its head.
int Cnf::pop() {
  const Pending last = clauses_.back();
  clauses_.pop_back();
  const auto begin = literals_.begin() + static_cast<std::ptrdiff_t>(last.begin);
  popped_.assign(begin, literals_.end());
  literals_.erase(begin, literals_.end());
  return last.head;
}

/// Writes the clause of the head and the literals in popped_.
void Cnf::write(int head) {
  if (!flatten(popped_) || distribute(head)) return;
  buffer_.clear();
  if (head != 0) buffer_.push_back(head);
  for (const Literal literal : popped_) buffer_.push_back(demand(literal));
  sink_.clause(buffer_);
}

/// Writes a clause without looking for gates that could become part of it. There are many of these clauses.
void Cnf::write_plain(int head, std::span<const Literal> literals) {
  buffer_.clear();
  if (head != 0) buffer_.push_back(head);
  for (const Literal literal : literals) {
    if (literal == kTrueLiteral) return;
    if (literal != kFalseLiteral) buffer_.push_back(demand(literal));
  }
  sink_.clause(buffer_);
}

/// Replaces disjunctions by their operands. Returns false if the clause always holds.
bool Cnf::flatten(std::vector<Literal>& literals) const {
  for (std::size_t i = 0; i < literals.size();) {
    const Literal literal = literals[i];
    if (is_disjunction(literal) && inlinable(literal)) {
      const auto& operands = circuit_.gate(literal).operands;
      literals[i] = !operands[0];
      literals.push_back(!operands[1]);
    } else {
      ++i;
    }
  }
  std::sort(literals.begin(), literals.end());
  literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
  std::erase(literals, kFalseLiteral);
  if (!literals.empty() && literals.front() == kTrueLiteral) return false;
  return std::adjacent_find(literals.begin(), literals.end(), [](Literal a, Literal b) { return a == !b; }) ==
         literals.end();
}

/// If exactly one literal of popped_ is a gate that gets no variable of its own, and the clause is short,
/// pushes the clauses that the head and popped_ stand for in terms of the gate's operands, and returns true.
bool Cnf::distribute(int head) {
  const std::size_t size = popped_.size() + (head != 0 ? 1 : 0);
  if (size > tuning::kMostRepeated + 1) return false;
  const auto inlined = [this](Literal literal) { return inlinable(literal); };
  const auto at = std::find_if(popped_.begin(), popped_.end(), inlined);
  if (at == popped_.end()) return false;
  if (std::find_if(at + 1, popped_.end(), inlined) != popped_.end()) return false;
  rest_.assign(popped_.begin(), at);
  rest_.insert(rest_.end(), at + 1, popped_.end());
  push_meaning(*at, {head, rest_});
  return true;
}

void Cnf::define(Literal literal) {
  const int number = numbers_[literal.gate()];
  push_meaning(literal, {literal.negated() ? number : -number, {}});
}

/// Pushes clauses saying that the literal or the rest holds, in terms of the operands of the literal's gate.
void Cnf::push_meaning(Literal literal, const Clause& rest) {
  const auto push = [&](std::initializer_list<Literal> literals) {
    push_clause(rest, {literals.begin(), literals.end()});
  };
  const bool negated = literal.negated();
  const auto [a, b, c] = circuit_.gate(literal).operands;
  switch (circuit_.gate(literal).kind) {
    case Circuit::Kind::kInput:
      return;
    case Circuit::Kind::kAnd:
      return negated ? push({!a, !b}) : push_conjuncts(literal, rest);
    case Circuit::Kind::kXor:
      push({a ^ negated, b});
      return push({!a ^ negated, !b});
    case Circuit::Kind::kMux:
      push({!a, b ^ negated});
      return push({a, c ^ negated});  // that b or c holds follows, and made no search shorter
    case Circuit::Kind::kParity:
      push({a ^ negated, b, c});
      push({a ^ negated, !b, !c});
      push({!a ^ negated, b, !c});
      return push({!a ^ negated, !b, c});
    case Circuit::Kind::kMajority:
      push({a ^ negated, b ^ negated});
      push({a ^ negated, c ^ negated});
      return push({b ^ negated, c ^ negated});
    case Circuit::Kind::kDefined:
      return push_definition(circuit_.definition(literal), negated, rest);
  }
}

/// Pushes the clause of the rest and the literals.
void Cnf::push_clause(const Clause& rest, std::span<const Literal> literals) {
  push(rest);
  literals_.insert(literals_.end(), literals.begin(), literals.end());
}

void Cnf::push_definition(const Definition& definition, bool negated, const Clause& rest) {
  if (!rest.literals.empty()) {
    const auto push = [&](std::span<const Literal> literals) { push_clause(rest, literals); };
    return definition.write(negated, push);
  }
  if (rest.head != 0 && write_linear(rest.head, definition, negated)) return;
  const std::vector<OrderedPair> comparisons = definition.comparisons(negated);
  if (comparisons.size() == 1 && comparisons.front().relation == OrderedPair::Relation::kDifferent)
    return write_difference(rest.head, comparisons.front());
  if (comparisons.empty() || rest.head == 0) {
    const auto push = [&](std::span<const Literal> literals) { push_clause(rest, literals); };
    const auto write = [&](std::span<const Literal> literals) { write_plain(rest.head, literals); };
    return definition.is_linear() ? definition.write(negated, push) : definition.write(negated, write);
  }
  for (const OrderedPair& pair : comparisons) write_order(rest.head, pair);
}

/// Writes an order implication for each run of neighbouring values. Clauses of their own say what the lowest
/// value implies, and rule out values that would imply more than there is.
void Cnf::write_order(int head, const OrderedPair& pair) {
  const OrderEncodedInt *const smaller = pair.a, *const larger = pair.b;
  const std::int64_t offset = pair.relation == OrderedPair::Relation::kLess ? 1 : 0;
  write_plain(head, larger->at_least(smaller->values.front() + offset));
  OrderImplication order_implication{&chain(*smaller, true), &chain(*larger, false), -head};
  std::size_t implied = 0;
  for (std::uint32_t i = 0; i < smaller->reached.size(); ++i) {
    while (implied < larger->size() && larger->values[implied] < smaller->values[i + 1] + offset) ++implied;
    if (implied == larger->size()) {
      write_plain(head, !smaller->reached[i]);
      break;
    }
    if (implied == 0) continue;
    const auto at = static_cast<std::uint32_t>(implied - 1);
    if (order_implication.count > 0 && at == order_implication.base + order_implication.count) {
      ++order_implication.count;
      continue;
    }
    if (order_implication.count > 0) sink_.order_implication(order_implication);
    order_implication.first = i;
    order_implication.base = at;
    order_implication.count = 1;
  }
  if (order_implication.count > 0) sink_.order_implication(order_implication);
}

/// Writes an order difference for each run of neighbouring values that both ints have.
void Cnf::write_difference(int head, const OrderedPair& pair) {
  const std::vector<std::int64_t>&x = pair.a->values, &y = pair.b->values;
  OrderDifference difference{nullptr, nullptr, -head};
  for (const bool negated : {false, true}) {
    difference.a = &chain(*pair.a, negated);
    difference.b = &chain(*pair.b, negated);
  }
  const auto is_run = [](const std::vector<std::int64_t>& values) {
    return std::cmp_equal(values.back() - values.front() + 1, values.size());
  };
  const std::int64_t lo = std::max(x.front(), y.front()), hi = std::min(x.back(), y.back());
  if (is_run(x) && is_run(y) && lo <= hi) {
    difference.first = static_cast<std::uint32_t>(lo - x.front());
    difference.base = static_cast<std::uint32_t>(lo - y.front());
    difference.count = static_cast<std::uint32_t>(hi - lo + 1);
    return sink_.order_difference(difference);
  }
  const auto end_run = [&] {
    if (difference.count > 0) sink_.order_difference(difference);
    difference.count = 0;
  };
  for (std::uint32_t i = 0, j = 0; i < x.size() && j < y.size();) {
    if (x[i] != y[j]) {
      end_run();
      x[i] < y[j] ? ++i : ++j;
      continue;
    }
    if (difference.count++ == 0) difference.first = i, difference.base = j;
    ++i, ++j;
  }
  end_run();
}

/// Writes a linear implication, if the sink takes it and each int can stand in one term with weights that
/// only grow, or only fall. Its clauses wait until they are asked for. Returns false if it does not write it.
bool Cnf::write_linear(int head, const Definition& definition, bool negated) {
  if (!definition.is_linear() || !sink_.takes_linear_implications()) return false;
  const LinearBound bound = definition.linear(negated);
  LinearImplication implication{-head, {}, bound.least};
  std::unordered_map<const Chain*, std::size_t> places;
  for (const auto& [of, factor] : bound.terms) {
    const Chain& chain = chain_of(*of);
    const auto [place, is_new] = places.try_emplace(&chain, implication.terms.size());
    if (is_new) implication.terms.push_back({&chain.literals, std::vector<std::int64_t>(of->size())});
    std::vector<std::int64_t>& weights = implication.terms[place->second].weights;
    for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += factor * of->values[i];
  }
  for (const auto& [chain, weights] : implication.terms) {
    if (!std::ranges::is_sorted(weights) && !std::ranges::is_sorted(weights, std::ranges::greater{}))
      return false;
  }
  for (const auto& [of, factor] : bound.terms) chain(*of, factor < 0);
  sink_.linear_implication(implication);
  postponed_.push_back({head, &definition, negated});
  return true;
}

Cnf::Chain& Cnf::chain_of(const OrderEncodedInt& order) {
  Chain*& chain = chain_of_[&order];
  if (chain == nullptr) {
    const auto [entry, is_new] = chains_.try_emplace(order.reached);
    chain = &entry->second;
    for (const Literal literal : order.reached) {
      if (is_new) chain->literals.push_back(number(literal));
    }
  }
  return *chain;
}

/// Returns the numbers of the literals of an int in order encoding. All are defined in the direction that a
/// clause with them needs.
const std::vector<int>& Cnf::chain(const OrderEncodedInt& order, bool negated) {
  Chain& chain = chain_of(order);
  if (!std::exchange(chain.demanded[negated ? 1 : 0], true)) {
    for (const Literal literal : order.reached) demand(literal ^ negated);
  }
  return chain.literals;
}

void Cnf::push_conjuncts(Literal conjunction, const Clause& rest) {
  open_.assign(1, conjunction);
  while (!open_.empty()) {
    const Literal literal = open_.back();
    open_.pop_back();
    if (literal == conjunction || (is_conjunction(literal) && inlinable(literal))) {
      const auto& operands = circuit_.gate(literal).operands;
      open_.insert(open_.end(), {operands[1], operands[0]});
    } else {
      push_clause(rest, {&literal, 1});
    }
  }
}

/// Returns the number of a literal, and sees to it that it is defined in the direction in which it is used.
int Cnf::demand(Literal literal) {
  if (defined_.size() <= literal.code()) defined_.resize(2 * circuit_.size());
  if (circuit_.gate(literal).kind != Circuit::Kind::kInput && !defined_[literal.code()]) {
    defined_[literal.code()] = true;
    definitions_.push_back(literal);
  }
  return number(literal);
}

int Cnf::number(Literal literal) {
  if (numbers_.size() <= literal.gate()) numbers_.resize(circuit_.size());
  int& number = numbers_[literal.gate()];
  if (number == 0) number = ++variables_;
  return literal.negated() ? -number : number;
}

bool Cnf::inlinable(Literal literal) const {
  const Circuit::Gate& gate = circuit_.gate(literal);
  if (gate.kind == Circuit::Kind::kInput || gate.uses > 1 || has_number(literal)) return false;
  return gate.kind != Circuit::Kind::kDefined || !circuit_.definition(literal).is_linear() ||
         !sink_.takes_linear_implications();
}

}  // namespace solitaire
