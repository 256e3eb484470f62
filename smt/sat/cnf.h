#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "smt/sat/circuit.h"

namespace solitaire {

/// Clauses between two numbers told by order, each a chain of literals of which those up to some place hold:
/// where the guard holds, lower[first + i] implies upper[base + i] for each i < count.
struct OrderImplication {
  const std::vector<int>* lower = nullptr;  // of the Cnf, which has one for each number
  const std::vector<int>* upper = nullptr;
  int guard = 0;
  std::uint32_t first = 0, base = 0, count = 0;
};

/// Receives clauses. A literal is the number of a variable, from 1 on, or its negative.
class ClauseSink {
 public:
  virtual ~ClauseSink() = default;
  virtual void clause(std::span<const int> literals) = 0;
  /// By default, all of its clauses.
  virtual void order_implication(const OrderImplication& order_implication);
};

/// Writes what is required of a circuit's literals as clauses.
///
/// A gate becomes a variable only where it is used, with the clauses of the one direction in which it is used
/// (Plaisted and Greenbaum 1986); those of the other follow once that is needed. Of gates with a single use,
/// disjunctions become part of their clause, and conjunctions several clauses, without a variable.
class Cnf {
 public:
  Cnf(Circuit& circuit, ClauseSink& sink) : circuit_(circuit), sink_(sink) {}

  /// At least one of the literals holds.
  void add_clause(std::span<const Literal> literals);
  /// The number of a literal that can be assumed: where it holds, the circuit's literal holds.
  int assumable(Literal literal);
  /// The number of a literal that holds where the circuit's literal does, and nowhere else.
  int equivalent(Literal literal);
  /// The variable that stands for an input of the circuit.
  int variable(Literal input) { return number(input); }
  /// How many variables there are.
  int variables() const { return variables_; }
  /// The variable of an input, 0 if no clause has met the input yet.
  int known_variable(Literal input) const;

 private:
  struct Chain {
    std::vector<int> literals;
    bool demanded[2] = {false, false};  // not negated, negated
  };
  struct Clause {
    int head = 0;  // a literal as the sink knows it that stands before the others; 0: none
    std::span<const Literal> literals;
  };
  /// On the stack of clauses to be written: its literals are those from `begin` on up to the next one's.
  struct Pending {
    int head;
    std::size_t begin;
  };

  void write_all();
  void push(const Clause& clause);
  int pop();
  void write(int head);
  void write_plain(int head, std::initializer_list<Literal> literals);
  bool flatten(std::vector<Literal>& literals) const;
  bool distribute(int head);
  void write_comparison(int head, const OrderedPair& pair);
  const std::vector<int>& chain(const OrderEncodedInt& order, bool negated);
  void define(Literal literal);
  void push_meaning(Literal literal, const Clause& rest);
  void push_definition(const Definition& definition, bool negated, const Clause& rest);
  void push_clause(const Clause& rest, std::initializer_list<Literal> literals);
  void push_conjuncts(Literal conjunction, const Clause& rest);
  int demand(Literal literal);
  int number(Literal literal);

  bool has_number(Literal literal) const {
    return literal.gate() < numbers_.size() && numbers_[literal.gate()] != 0;
  }
  /// Whether a variable of its own for the gate would serve nothing but its one use.
  bool inlinable(Literal literal) const;
  bool is_conjunction(Literal literal) const {
    return circuit_.gate(literal).kind == Circuit::Kind::kAnd && !literal.negated();
  }
  bool is_disjunction(Literal literal) const {
    return circuit_.gate(literal).kind == Circuit::Kind::kAnd && literal.negated();
  }

  Circuit& circuit_;
  ClauseSink& sink_;
  int variables_ = 0;
  std::vector<int> numbers_;          // of the variables, by gate; 0: none yet
  std::vector<bool> defined_;         // by literal: whether it implies what it means
  std::vector<Pending> clauses_;      // to be written, and
  std::vector<Literal> literals_;     // theirs
  std::vector<Literal> definitions_;  // to be written
  std::vector<Literal> popped_;       // the literals of the clause that is being written,
  std::vector<Literal> rest_;         // all but one of them,
  std::vector<Literal> open_;         // the operands of that one which are left,
  std::vector<int> buffer_;           // and as the sink gets them
  std::unordered_map<const OrderEncodedInt*, std::unique_ptr<Chain>> chains_;
};

}  // namespace solitaire
