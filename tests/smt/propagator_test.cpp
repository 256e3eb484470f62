// Unit propagation against its definition: what follows from the clauses one by one until nothing does.
#include "smt/cdcl/propagator.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <vector>

#include "tests/smt/random_clauses.h"

namespace solitaire {
namespace {

constexpr int kVariableCount = 12;

/// By variable: -1 false, 1 true, 0 open; nothing if a clause is broken.
struct Naive {
  std::vector<int> values = std::vector<int>(kVariableCount + 1, 0);
  bool broken = false;

  int value(int literal) const {
    const int value = values[static_cast<std::size_t>(std::abs(literal))];
    return literal > 0 ? value : -value;
  }
  void assign(int literal) { values[static_cast<std::size_t>(std::abs(literal))] = literal > 0 ? 1 : -1; }

  void propagate(const std::vector<Clause>& clauses) {
    for (bool changed = true; changed;) {
      changed = false;
      for (const Clause& clause : clauses) {
        if (std::ranges::any_of(clause, [&](int literal) { return value(literal) > 0; })) continue;
        const auto open = std::ranges::count_if(clause, [&](int literal) { return value(literal) == 0; });
        if (open == 0) broken = true;
        if (open != 1) continue;
        assign(*std::ranges::find_if(clause, [&](int literal) { return value(literal) == 0; }));
        changed = true;
      }
    }
  }
};

/// What follows from the decisions.
Naive after(const std::vector<int>& decisions, const std::vector<Clause>& clauses) {
  Naive naive;
  for (const int decision : decisions) naive.assign(decision);
  naive.propagate(clauses);
  return naive;
}

/// A number told by order: each of its literals holds only where the one before it does.
std::vector<int> random_chain(std::mt19937_64& random, int first, std::size_t size,
                              std::vector<Clause>& clauses) {
  std::vector<int> chain;
  const int sign = random() % 2 == 0 ? 1 : -1;
  for (std::size_t i = 0; i < size; ++i) {
    chain.push_back(sign * (first + static_cast<int>(i)));
    if (i > 0) clauses.push_back({-chain[i], chain[i - 1]});
  }
  return chain;
}

/// Appends the clauses that conditions stand for.
class Expanded : public ClauseSink {
 public:
  explicit Expanded(std::vector<Clause>& clauses) : clauses_(clauses) {}
  void clause(std::span<const int> literals) override {
    clauses_.emplace_back(literals.begin(), literals.end());
  }

 private:
  std::vector<Clause>& clauses_;
};

}  // namespace

TEST_CASE("propagator: what follows from conditions on ints is what follows from their clauses") {
  std::size_t conflicts = 0, consequences = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    Propagator propagator;
    propagator.reserve(kVariableCount);
    std::vector<Clause> clauses;  // of chains, and others
    const std::vector<int> chains[] = {random_chain(random, 1, 4, clauses),
                                       random_chain(random, 5, 3, clauses)};
    for (std::size_t i = random() % 12; i > 0; --i)
      clauses.push_back(random_clause(random, kVariableCount, 1, 5));
    for (const Clause& clause : clauses) propagator.clause(clause);
    for (std::size_t i = 2 + random() % 5; i > 0; --i) {
      const std::size_t lower = random() % 2;
      OrderImplication order_implication{&chains[lower], &chains[1 - lower]};
      order_implication.guard = (8 + static_cast<int>(random() % 5)) * (random() % 2 == 0 ? 1 : -1);
      order_implication.first = static_cast<std::uint32_t>(random() % order_implication.lower->size());
      order_implication.base = static_cast<std::uint32_t>(random() % order_implication.upper->size());
      const std::size_t most = std::min(order_implication.lower->size() - order_implication.first,
                                        order_implication.upper->size() - order_implication.base);
      order_implication.count = 1 + static_cast<std::uint32_t>(random() % most);
      propagator.order_implication(order_implication);
      for (std::uint32_t at = 0; at < order_implication.count; ++at)
        clauses.push_back({-order_implication.guard,
                           -(*order_implication.lower)[order_implication.first + at],
                           (*order_implication.upper)[order_implication.base + at]});
    }
    for (std::size_t i = random() % 4; i > 0; --i) {
      OrderDifference difference{&chains[0], &chains[1]};
      if (random() % 2 == 0) difference.guard = 8 + static_cast<int>(random() % 5);
      difference.first = static_cast<std::uint32_t>(random() % 4);
      difference.base = static_cast<std::uint32_t>(random() % 3);
      difference.count =
          1 + static_cast<std::uint32_t>(random() % std::min(5 - difference.first, 4 - difference.base));
      propagator.order_difference(difference);
      Expanded expanded(clauses);
      expanded.order_difference(difference);
    }
    std::vector<int> decisions;
    for (int step = 0; step < 60; ++step) {
      Naive naive = after(decisions, clauses);
      REQUIRE(propagator.propagate() == !naive.broken);
      conflicts += naive.broken ? 1 : 0;
      if (naive.broken && decisions.empty()) break;
      std::vector<int> open;
      for (int variable = 1; variable <= kVariableCount && !naive.broken; ++variable) {
        REQUIRE(propagator.value(variable) == naive.value(variable));
        if (naive.value(variable) == 0) open.push_back(variable);
      }
      consequences += naive.broken ? 0 : kVariableCount - open.size() - decisions.size();
      if (!open.empty() && random() % 4 != 0) {
        decisions.push_back(decide_randomly(propagator, open, random));
      } else {
        for (std::size_t i = random() % 3; !decisions.empty() && (naive.broken || i > 0);
             i -= i > 0 ? 1 : 0) {
          propagator.undo();
          decisions.pop_back();
          naive.broken = false;
        }
      }
    }
  }
  CHECK(conflicts > 200);
  CHECK(consequences > 5000);
}

TEST_CASE("propagator: assigns what follows, also from clauses that come between searches") {
  std::size_t conflicts = 0, consequences = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    Propagator propagator;
    propagator.reserve(kVariableCount);
    std::vector<Clause> clauses;
    for (int round = 0; round < 4; ++round) {
      for (std::size_t i = random() % 8; i > 0; --i) {
        clauses.push_back(random_clause(random, kVariableCount, 1, 5));
        propagator.clause(clauses.back());
      }
      std::vector<int> decisions;
      while (true) {
        Naive naive = after(decisions, clauses);
        REQUIRE(propagator.propagate() == !naive.broken);
        if (naive.broken) {
          ++conflicts;
          break;
        }
        std::vector<int> open;
        for (int variable = 1; variable <= kVariableCount; ++variable) {
          REQUIRE(propagator.value(variable) == naive.value(variable));
          REQUIRE(propagator.value(-variable) == naive.value(-variable));
          if (naive.value(variable) == 0) open.push_back(variable);
        }
        consequences += kVariableCount - open.size() - decisions.size();
        if (open.empty()) break;
        decisions.push_back(decide_randomly(propagator, open, random));
        CHECK(propagator.decisions() == decisions.size());
      }
      while (propagator.decisions() > 0) {
        CHECK(propagator.undo() == decisions.back());
        decisions.pop_back();
      }
      if (!propagator.propagate()) break;  // nothing fulfils the clauses any more
    }
  }
  CHECK(conflicts > 50);
  CHECK(consequences > 1000);
}

}  // namespace solitaire
