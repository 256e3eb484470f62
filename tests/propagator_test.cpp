// Unit propagation against its definition: what follows from the clauses one by one until nothing does.
#include "smt/propagator.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace solitaire {
namespace {

constexpr int kVariables = 12;
using Clause = std::vector<int>;

/// By variable: -1 false, 1 true, 0 open; nothing if a clause is broken.
struct Naive {
  std::vector<int> values = std::vector<int>(kVariables + 1, 0);
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

Clause random_clause(std::mt19937_64& random) {
  Clause clause;
  const std::size_t size = 1 + random() % 5;
  while (clause.size() < size) {
    const int variable = 1 + static_cast<int>(random() % kVariables);
    const auto same = [&](int literal) { return std::abs(literal) == variable; };
    if (std::ranges::none_of(clause, same)) clause.push_back(random() % 2 == 0 ? variable : -variable);
  }
  return clause;
}

}  // namespace

TEST_CASE("propagator: assigns what follows, also from clauses that come between searches") {
  std::size_t conflicts = 0, consequences = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    Propagator propagator;
    propagator.reserve(kVariables);
    std::vector<Clause> clauses;
    for (int round = 0; round < 4; ++round) {
      for (std::size_t i = random() % 8; i > 0; --i) {
        clauses.push_back(random_clause(random));
        propagator.clause(clauses.back());
      }
      std::vector<int> decisions;
      while (true) {
        Naive naive;
        for (const int decision : decisions) naive.assign(decision);
        naive.propagate(clauses);
        REQUIRE(propagator.propagate() == !naive.broken);
        if (naive.broken) {
          ++conflicts;
          break;
        }
        std::vector<int> open;
        for (int variable = 1; variable <= kVariables; ++variable) {
          REQUIRE(propagator.value(variable) == naive.value(variable));
          REQUIRE(propagator.value(-variable) == naive.value(-variable));
          if (naive.value(variable) == 0) open.push_back(variable);
        }
        consequences += kVariables - open.size() - decisions.size();
        if (open.empty()) break;
        const int variable = open[random() % open.size()];
        decisions.push_back(random() % 2 == 0 ? variable : -variable);
        propagator.decide(decisions.back());
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
