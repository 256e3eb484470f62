#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "smt/sat/circuit.h"

namespace solitaire {

/// Stands for many clauses between two ints in order encoding. Each int is a chain of literals, of which
/// those up to some place hold. The clauses say: where the guard holds, lower[first + i] implies upper[base +
/// i] for each i < count.
struct OrderImplication {
  const std::vector<int>* lower = nullptr;  // owned by the Cnf, which has one chain for each int
  const std::vector<int>* upper = nullptr;
  int guard = 0;
  std::uint32_t first = 0, base = 0, count = 0;
};

/// Stands for clauses that two ints in order encoding differ: where the guard holds, they do not have their
/// values number first + i and base + i, from the lowest on, for each i < count. With 0 as the guard that is
/// always so.
struct OrderDifference {
  const std::vector<int>* a = nullptr;
  const std::vector<int>* b = nullptr;
  int guard = 0;
  std::uint32_t first = 0, base = 0, count = 0;
};

/// Says of ints in order encoding: where the guard holds, the weights of their values add up to the least at
/// least. Each int stands in one term, with weights that never fall from value to value, or never grow.
struct LinearImplication {
  struct Term {
    const std::vector<int>* chain = nullptr;
    std::vector<std::int64_t> weights;  // one for each value of the int, from the lowest on
  };
  int guard = 0;
  std::vector<Term> terms;
  std::int64_t least = 0;
};

/// Receives clauses. A literal is the number of a variable, from 1 on, or its negative.
class ClauseSink {
 public:
  virtual ~ClauseSink() = default;
  virtual void clause(std::span<const int> literals) = 0;
  /// Receives an order implication. By default, each of its clauses is passed to clause().
  virtual void order_implication(const OrderImplication& order_implication);
  /// Does the same for an order difference.
  virtual void order_difference(const OrderDifference& difference);
  /// Returns true if linear_implication() can be called. Of a sink that takes none, clauses say the same.
  virtual bool takes_linear_implications() const { return false; }
  virtual void linear_implication(const LinearImplication& /*implication*/) {}
};

/// Writes what is required of a circuit's literals as clauses.
///
/// A gate becomes a variable only where it is used, with the clauses of the one direction in which it is used
/// (Plaisted and Greenbaum 1986). The clauses of the other direction follow once that is needed. Gates with a
/// single use need no variable: a disjunction becomes part of the clause that uses it, and a conjunction
/// turns that clause into several.
class Cnf {
 public:
  Cnf(Circuit& circuit, ClauseSink& sink) : circuit_(circuit), sink_(sink) {}

  /// Requires that at least one of the literals holds.
  void add_clause(std::span<const Literal> literals);
  /// Requires that two ints in order encoding differ, whose literals are used (use()).
  void require_different(const OrderEncodedInt& a, const OrderEncodedInt& b);
  /// Returns the number of a literal that can be assumed. Where it holds, the circuit's literal holds.
  int assumable(Literal literal);
  /// Returns the number of a literal that holds where the circuit's literal does, and nowhere else.
  int equivalent(Literal literal);
  /// Writes clauses that say what the linear implications so far do, for what takes clauses alone.
  void write_linear_as_clauses();
  /// Returns the variable that stands for an input of the circuit.
  int variable(Literal input) { return number(input); }
  /// Returns how many variables there are.
  int variables() const { return variables_; }
  /// Returns the variable of an input, or 0 if no clause contains the input yet.
  int known_variable(Literal input) const;

 private:
  /// Of each int in order encoding, and of all others that differ from it in their values alone.
  struct Chain {
    std::vector<int> literals;
    bool demanded[2] = {false, false};  // not negated, negated
  };
  /// A literal that implies what a definition says, by clauses that are not written yet.
  struct Postponed {
    int head;
    const Definition* definition;
    bool negated;
  };
  struct Clause {
    int head = 0;  // a further literal, as the sink numbers it, that comes before the others; 0: none
    std::span<const Literal> literals;
  };
  /// A clause on the stack of clauses to be written. Its literals are those from `begin` up to the beginning
  /// of the next clause on the stack.
  struct Pending {
    int head;
    std::size_t begin;
  };

  void write_all();
  void push(const Clause& clause);
  int pop();
  void write(int head);
  void write_plain(int head, std::span<const Literal> literals);
  void write_plain(int head, Literal literal) { write_plain(head, {&literal, 1}); }
  bool flatten(std::vector<Literal>& literals) const;
  bool distribute(int head);
  void write_order(int head, const OrderedPair& pair);
  void write_difference(int head, const OrderedPair& pair);
  bool write_linear(int head, const Definition& definition, bool negated);
  Chain& chain_of(const OrderEncodedInt& order);
  const std::vector<int>& chain(const OrderEncodedInt& order, bool negated);
  void define(Literal literal);
  void push_meaning(Literal literal, const Clause& rest);
  void push_definition(const Definition& definition, bool negated, const Clause& rest);
  void push_clause(const Clause& rest, std::span<const Literal> literals);
  void push_conjuncts(Literal conjunction, const Clause& rest);
  int demand(Literal literal);
  int number(Literal literal);

  bool has_number(Literal literal) const {
    return literal.gate() < numbers_.size() && numbers_[literal.gate()] != 0;
  }
  /// Returns true if a variable for the gate would have a single use.
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
  bool is_writing_ = false;
  std::vector<int> numbers_;          // of the variables, by gate; 0: none yet
  std::vector<bool> defined_;         // by literal: whether it implies what it means
  std::vector<Pending> clauses_;      // to be written, and
  std::vector<Literal> literals_;     // theirs
  std::vector<Literal> definitions_;  // to be written
  std::vector<Literal> popped_;       // the literals of the clause that is being written,
  std::vector<Literal> rest_;         // all but one of them,
  std::vector<Literal> open_;         // the operands of that one which are left,
  std::vector<int> buffer_;           // and as the sink gets them
  std::vector<Postponed> postponed_;
  std::map<std::vector<Literal>, Chain> chains_;  // by the literals in the circuit
  std::unordered_map<const OrderEncodedInt*, Chain*> chain_of_;
};

}  // namespace solitaire
