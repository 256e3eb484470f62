#include "smt/cnf.h"

#include <algorithm>
#include <utility>

namespace solitaire {
namespace {

/// A conjunction in a clause of at most so many other literals makes as many clauses as it has operands, all
/// with these literals; in a longer clause it gets a variable.
constexpr std::size_t kMaxRepeated = 3;

}  // namespace

void Cnf::add_clause(std::span<const Literal> literals) {
  for (const Literal literal : literals) circuit_.use(literal);
  clauses_.push_back({0, {literals.begin(), literals.end()}});
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

/// Clauses make definitions necessary and these make clauses; on own stacks, as the circuit can be deeper
/// than the machine's.
void Cnf::write_all() {
  while (true) {
    if (!clauses_.empty()) {
      Clause clause = std::move(clauses_.back());
      clauses_.pop_back();
      write(std::move(clause));
    } else if (!definitions_.empty()) {
      const Literal literal = definitions_.back();
      definitions_.pop_back();
      define(literal);
    } else {
      return;
    }
  }
}

void Cnf::write(Clause clause) {
  if (!flatten(clause.literals) || distribute(clause)) return;
  buffer_.clear();
  if (clause.head != 0) buffer_.push_back(clause.head);
  for (const Literal literal : clause.literals) buffer_.push_back(demand(literal));
  sink_.clause(buffer_);
}

/// Without looking for what could be part of the clause: there are many of these.
void Cnf::write_plain(int head, std::initializer_list<Literal> literals) {
  buffer_.clear();
  if (head != 0) buffer_.push_back(head);
  for (const Literal literal : literals) {
    if (literal == kTrueLiteral) return;
    if (literal != kFalseLiteral) buffer_.push_back(demand(literal));
  }
  sink_.clause(buffer_);
}

/// Replaces disjunctions by their operands; false if the clause always holds.
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

bool Cnf::distribute(const Clause& clause) {
  const std::size_t size = clause.literals.size() + (clause.head != 0 ? 1 : 0);
  if (size > kMaxRepeated + 1) return false;
  const auto inlined = [this](Literal literal) { return inlinable(literal); };
  const auto at = std::find_if(clause.literals.begin(), clause.literals.end(), inlined);
  if (at == clause.literals.end()) return false;
  if (std::find_if(at + 1, clause.literals.end(), inlined) != clause.literals.end()) return false;
  Clause rest = clause;
  std::erase(rest.literals, *at);
  push_meaning(*at, rest);
  return true;
}

void Cnf::define(Literal literal) {
  const int number = numbers_[literal.gate()];
  push_meaning(literal, {literal.negated() ? number : -number, {}});
}

/// Writes that the literal or the rest holds, in terms of the gate's operands.
void Cnf::push_meaning(Literal literal, const Clause& rest) {
  const auto push = [&](std::initializer_list<Literal> literals) {
    clauses_.push_back(rest);
    clauses_.back().literals.insert(clauses_.back().literals.end(), literals);
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
      if (!rest.literals.empty()) return circuit_.definition(literal).write(negated, push);
      return circuit_.definition(literal).write(
          negated, [&](std::initializer_list<Literal> literals) { write_plain(rest.head, literals); });
  }
}

void Cnf::push_conjuncts(Literal conjunction, const Clause& rest) {
  std::vector<Literal> open{conjunction};
  while (!open.empty()) {
    const Literal literal = open.back();
    open.pop_back();
    if (literal == conjunction || (is_conjunction(literal) && inlinable(literal))) {
      const auto& operands = circuit_.gate(literal).operands;
      open.insert(open.end(), {operands[1], operands[0]});
    } else {
      clauses_.push_back(rest);
      clauses_.back().literals.push_back(literal);
    }
  }
}

/// The literal's number, and its definition in this direction.
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
  return gate.kind != Circuit::Kind::kInput && gate.uses <= 1 && !has_number(literal);
}

}  // namespace solitaire
