// Pairs of ints that a table allows: one operation, which looks the table up.
#include <doctest/doctest.h>
#include <random>

#include "smt/cdcl/enumerator.h"
#include "smt/nearby_then_cadical.h"
#include "smt/sat/cadical_solver.h"
#include "smt/write_smtlib.h"
#include "smt/z3/z3_solver.h"
#include "tests/solve/proof.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

PairTable random_table(std::mt19937_64& random) {
  PairTable pairs(1 + random() % 7, 1 + random() % 7);
  for (std::size_t row = 0; row < pairs.rows(); ++row) {
    for (std::size_t column = 0; column < pairs.columns(); ++column) {
      if (random() % 3 == 0) pairs.allow(row, column);
    }
  }
  return pairs;
}

/// Two choices and whether a table allows their values. One of the domains is so wide that it has no order.
struct Pair {
  explicit Pair(std::uint64_t seed) : random(seed), pairs(random_table(random)) {
    const Distribution domains[] = {{0, 3, 1, {}}, {0, 6, 1, {}}, {-2, 4, 1, {}},
                                    {1, 9, 2, {}}, {3, 8, 1, {}}, {0, 3000, 1, {}}};
    x = choice(domains[random() % std::size(domains)]);
    y = choice(domains[random() % std::size(domains)]);
    allowed = graph.apply(Op::kAllowed, {x, y, graph.table(pairs)});
  }

  NodeId choice(const Distribution& domain) {
    const std::string name = std::to_string(graph.variables().size());
    return graph.choice({addresses.site(addresses.root(), name), domain});
  }
  NodeId is(NodeId node, std::int64_t value) {
    return graph.apply(Op::kEqInt, {node, graph.constant(value)});
  }
  /// Calls `visit` with values of both, all those that the table has and some beyond.
  template <class Visit>
  void each_pair(Visit visit) {
    const Distribution &of_x = graph.variable(x).domain, &of_y = graph.variable(y).domain;
    for (std::int64_t a = of_x.lo; a <= std::min<std::int64_t>(of_x.hi, 8); a += of_x.step) {
      for (std::int64_t b = of_y.lo; b <= std::min<std::int64_t>(of_y.hi, 8); b += of_y.step) visit(a, b);
    }
  }

  std::mt19937_64 random;
  Graph graph;
  AddressTable addresses;
  PairTable pairs;
  NodeId x, y, allowed;
};

TEST_CASE("allowed: equal tables are one node, and known values are looked up at once") {
  Graph graph;
  PairTable pairs(2, 2), others(2, 2);
  pairs.allow(0, 1);
  others.allow(0, 1);
  const NodeId table = graph.table(pairs);
  CHECK(graph.table(others) == table);
  others.allow(1, 1);
  CHECK(graph.table(others) != table);
  CHECK(graph.table(pairs) == table);
  const auto looked_up = [&](std::int64_t a, std::int64_t b) {
    return graph.apply(Op::kAllowed, {graph.constant(a), graph.constant(b), table});
  };
  CHECK(looked_up(0, 1) == kTrue);
  CHECK(looked_up(1, 0) == kFalse);
  CHECK(looked_up(-1, 1) == kFalse);
  CHECK(looked_up(0, 2) == kFalse);
}

TEST_CASE("allowed: every solver allows the pairs of the table and no others (slow)") {
  const StopSignal never;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Pair pair(seed);
    CAPTURE(seed);
    for (const bool wanted : {true, false}) {
      const NodeId condition = wanted ? pair.allowed : pair.graph.negation(pair.allowed);
      std::unique_ptr<Solver> solvers[] = {make_cadical_solver(pair.graph),
                                           make_nearby_then_cadical(pair.graph, {}),
                                           make_z3_solver(pair.graph, pair.addresses, {})};
      for (const auto& solver : solvers) solver->add_clause({&condition, 1});
      pair.each_pair([&](std::int64_t a, std::int64_t b) {
        const bool holds = pair.pairs.allows(a, b) == wanted;
        Assignment values(pair.graph,
                          [&](std::size_t variable) { return Scalar::of(variable == 0 ? a : b); });
        CHECK(values.holds(condition) == holds);
        const NodeId assumed[] = {pair.is(pair.x, a), pair.is(pair.y, b)};
        for (const auto& solver : solvers)
          CHECK((solver->check(assumed, never) == Verdict::kSatisfiable) == holds);
      });
    }
  }
}

TEST_CASE("allowed: the formula that others check says the same") {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Pair pair(seed);
    CAPTURE(seed);
    pair.each_pair([&](std::int64_t a, std::int64_t b) {
      if (pair.random() % 4 != 0) return;
      const NodeId conditions[] = {pair.allowed, pair.is(pair.x, a), pair.is(pair.y, b)};
      CHECK(cvc5_verdict(to_smt2(pair.graph, pair.addresses, conditions)) ==
            (pair.pairs.allows(a, b) ? "sat" : "unsat"));
    });
  }
}

TEST_CASE("allowed: enumeration gives each pair once") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Pair pair(seed);
    CAPTURE(seed);
    std::size_t expected = 0, found = 0;
    pair.each_pair([&](std::int64_t a, std::int64_t b) { expected += pair.pairs.allows(a, b) ? 1 : 0; });
    const std::size_t variables[] = {0, 1};
    Enumerator enumerator(pair.graph, {&pair.allowed, 1}, {variables, pair.graph.variables().size()});
    while (enumerator.next(StopSignal()) == Enumerator::Outcome::kFound) {
      ++found;
      CHECK(pair.pairs.allows(enumerator.value(0), enumerator.value(1)));
    }
    CHECK(found == expected);
  }
}

}  // namespace
}  // namespace solitaire
