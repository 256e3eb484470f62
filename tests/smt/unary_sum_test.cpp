// Sums that are counted in unary: a bound follows from the terms, and the terms from a bound, as soon as that
// is so.
#include "smt/sat/unary_sum.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <vector>

#include "smt/cdcl/propagator.h"
#include "smt/sat/cnf.h"

namespace solitaire {
namespace {

/// Terms of which nothing is known, in clauses that a propagator has. Where they are counted, they have two
/// values, and those of either half have one factor.
struct OpenTerms {
  OpenTerms(std::mt19937_64& random, std::size_t count, bool are_counted) {
    const std::int64_t first_half = random() % 2 == 0 ? 1 : -2, second_half = random() % 2 == 0 ? 1 : -2;
    for (std::size_t i = 0; i < count; ++i) {
      OrderEncodedInt& term =
          orders.emplace_back(constant_order(static_cast<std::int64_t>(random() % 5) - 2));
      const std::size_t size = are_counted ? 2 : 2 + random() % 3;
      while (term.size() < size) {
        const std::int64_t more = are_counted ? 0 : static_cast<std::int64_t>(random() % 3);
        term.values.push_back(term.values.back() + 1 + more);
        term.reached.push_back(circuit.input());
        if (term.size() == 2) continue;
        const Literal reached_before[] = {!term.reached.back(), term.reached.end()[-2]};
        cnf.add_clause(reached_before);
      }
      const std::int64_t factor = i < count / 2 ? first_half : second_half;
      factors.push_back(are_counted ? factor : random() % 2 == 0 ? 1 : -2);
    }
  }

  LinearBound bound() const {
    LinearBound made;
    for (std::size_t i = 0; i < orders.size(); ++i) made.terms.push_back({&orders[i], factors[i]});
    return made;
  }

  /// The number of the literal, negative if it is negated.
  int variable(Literal literal) {
    const int number = cnf.variable(literal);
    propagator.reserve(std::abs(number));
    return number;
  }

  /// The most that the terms can come to.
  std::int64_t most() {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < orders.size(); ++i) sum += most_of(i);
    return sum;
  }

  /// The most that one of them can come to, if the literal fails, too.
  std::int64_t most_of(std::size_t i, Literal failing = kFalseLiteral) {
    std::vector<std::int64_t> left;
    for (std::size_t j = 0; j < orders[i].size() && !fails(orders[i].reaches(j), failing); ++j) {
      if (holds(orders[i].reaches(j), failing)) left.clear();
      left.push_back(factors[i] * orders[i].values[j]);
    }
    return std::ranges::max(left);
  }

  bool holds(Literal literal, Literal failing) { return fails(!literal, failing); }
  bool fails(Literal literal, Literal failing) {
    if (is_constant(literal)) return literal == kFalseLiteral;
    if (literal == failing) return true;
    return propagator.value(variable(literal)) < 0;
  }

  Circuit circuit;
  Propagator propagator;
  Cnf cnf{circuit, propagator};
  std::vector<OrderEncodedInt> orders;
  std::vector<std::int64_t> factors;
};

/// With these, counts of 32 terms and more are merged.
constexpr UnarySum::Limits kLimits{100'000, 256};

/// Few terms, or so many to be counted that they are merged.
OpenTerms drawn_terms(std::mt19937_64& random, int round) {
  if (round % 10 == 0) return {random, 40 + random() % 90, true};
  return {random, 1 + random() % 6, false};
}

std::int64_t below(std::mt19937_64& random, std::size_t end) {
  return static_cast<std::int64_t>(random() % end);
}

}  // namespace

TEST_CASE("unary sums: what follows from a bound, once some terms are known, is assigned") {
  std::mt19937_64 random(1);
  int left = 0;
  for (int round = 0; round < 300; ++round) {
    OpenTerms terms = drawn_terms(random, round);
    auto sum = UnarySum::of(terms.bound(), kLimits);
    REQUIRE(sum);
    const std::int64_t bound = terms.most() - below(random, terms.orders.size() > 6 ? 90 : 8);
    const int asked = terms.cnf.assumable(sum->at_least(terms.circuit, bound));
    std::vector<Literal> inputs;
    for (const OrderEncodedInt& order : terms.orders)
      inputs.insert(inputs.end(), order.reached.begin(), order.reached.end());
    std::ranges::shuffle(inputs, random);
    for (const Literal input : inputs) terms.variable(input);
    terms.propagator.reserve(std::abs(asked));
    REQUIRE(terms.propagator.propagate());
    if (terms.propagator.is_open(asked)) terms.propagator.decide(asked);
    bool possible = terms.propagator.propagate();
    for (const Literal input : inputs) {
      CHECK(possible);  // as each literal that has to hold does
      if (!possible) break;
      const std::int64_t most = terms.most();
      CHECK(most >= bound);
      for (std::size_t i = 0; i < terms.orders.size(); ++i) {
        for (const Literal literal : terms.orders[i].reached) {
          const Literal needed = terms.factors[i] > 0 ? literal : !literal;
          if (!terms.propagator.is_open(terms.variable(literal))) continue;
          CHECK(most - terms.most_of(i) + terms.most_of(i, needed) >= bound);
          ++left;
        }
      }
      const int variable = terms.variable(input);
      if (!terms.propagator.is_open(variable)) continue;
      terms.propagator.decide(random() % 2 == 0 ? variable : -variable);
      possible = terms.propagator.propagate();
    }
  }
  CHECK(left > 1000);
}

TEST_CASE("unary sums: a bound allows the values that come to it, and no others") {
  std::mt19937_64 random(2);
  int allowed = 0, ruled_out = 0;
  for (int round = 0; round < 300; ++round) {
    OpenTerms terms = drawn_terms(random, round);
    auto sum = UnarySum::of(terms.bound(), kLimits);
    REQUIRE(sum);
    std::vector<int> decisions;
    std::int64_t total = 0;
    for (std::size_t i = 0; i < terms.orders.size(); ++i) {
      const OrderEncodedInt& order = terms.orders[i];
      const std::size_t value = random() % order.size();
      total += terms.factors[i] * order.values[value];
      for (std::size_t j = 1; j < order.size(); ++j)
        decisions.push_back(j <= value ? terms.variable(order.reaches(j))
                                       : -terms.variable(order.reaches(j)));
    }
    const std::int64_t bound = total + below(random, 7) - 3;
    decisions.push_back(terms.cnf.assumable(sum->at_least(terms.circuit, bound)));
    terms.propagator.reserve(std::abs(decisions.back()));
    bool possible = terms.propagator.propagate();
    for (const int decision : decisions) {
      if (possible && terms.propagator.is_open(decision)) {
        terms.propagator.decide(decision);
        possible = terms.propagator.propagate();
      }
      possible = possible && terms.propagator.value(decision) > 0;
    }
    CHECK(possible == (total >= bound));
    ++(possible ? allowed : ruled_out);
  }
  CHECK(allowed > 50);
  CHECK(ruled_out > 50);
}

TEST_CASE("unary sums: none of too many pairs of values") {
  std::mt19937_64 random(3);
  OpenTerms terms(random, 8, false);
  CHECK(UnarySum::of(terms.bound(), {10'000}));
  CHECK_FALSE(UnarySum::of(terms.bound(), {50}));
}

}  // namespace solitaire
