// Sums of many pairs of values that are compared so often that they are written in order: all comparisons of
// them hold for exactly the values that they should.
#include "smt/sat/constrained_sum.h"

#include <doctest/doctest.h>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "smt/cdcl/enumerator.h"
#include "smt/sat/bit_blast.h"
#include "smt/sat/cadical_solver.h"

namespace solitaire {
namespace {

using Pair = std::pair<std::int64_t, std::int64_t>;

constexpr std::int64_t kWidest = 44;  // so that there are more than tuning::kMostOrderedSum pairs

/// Two ints from -3 and from 0 on, and conditions on their sum and their difference.
struct ComparedSums {
  ComparedSums() {
    x = graph.choice({addresses.address("x"), Distribution::range(-3, kWidest - 3)});
    y = graph.choice({addresses.address("y"), Distribution::range(0, kWidest)});
    sum = graph.apply(Op::kAdd, {x, y});
    difference = graph.apply(Op::kSub, {x, y});
  }

  NodeId compare(Op op, NodeId a, std::int64_t b) { return graph.apply(op, {a, graph.constant(b)}); }

  /// Adds that an int is none of every fifth value from `first` on. These are the many comparisons.
  void leave_out(NodeId of, std::int64_t first) {
    for (int i = 0; i < 9; ++i) conditions.push_back(graph.negation(compare(Op::kEqInt, of, first + 5 * i)));
  }

  std::set<Pair> expected(const std::function<bool(std::int64_t, std::int64_t)>& holds) const {
    std::set<Pair> all;
    for (std::int64_t a = -3; a <= kWidest - 3; ++a) {
      for (std::int64_t b = 0; b <= kWidest; ++b) {
        if (holds(a, b)) all.emplace(a, b);
      }
    }
    return all;
  }

  std::set<Pair> enumerated() const {
    const std::size_t choices[] = {0, 1};
    Enumerator enumerator(graph, conditions, choices);
    const StopSignal never;
    std::set<Pair> all;
    while (enumerator.next(never) == Enumerator::Outcome::kFound)
      CHECK(all.emplace(enumerator.value(0), enumerator.value(1)).second);
    return all;
  }

  std::set<Pair> listed() {
    const auto solver = make_cadical_solver(graph, 0);
    for (const NodeId condition : conditions) solver->add_clause({&condition, 1});
    const StopSignal never;
    std::set<Pair> all;
    while (solver->check({}, never) == Verdict::kSatisfiable) {
      const auto [entry, is_new] = all.emplace(solver->value(0), solver->value(1));
      REQUIRE(is_new);
      const NodeId other[] = {graph.negation(compare(Op::kEqInt, x, entry->first)),
                              graph.negation(compare(Op::kEqInt, y, entry->second))};
      solver->add_clause(other);
    }
    return all;
  }

  Graph graph;
  AddressTable addresses;
  NodeId x, y, sum, difference;
  std::vector<NodeId> conditions;
};

bool left_out(std::int64_t value, std::int64_t first) {
  return value >= first && value < first + 45 && (value - first) % 5 == 0;
}

}  // namespace

TEST_CASE("constrained sums: what is left where many values are left out") {
  ComparedSums sums;
  sums.leave_out(sums.sum, 10);
  sums.leave_out(sums.difference, -20);
  sums.conditions.push_back(sums.compare(Op::kLtInt, sums.sum, 60));
  sums.conditions.push_back(sums.graph.negation(sums.compare(Op::kLeInt, sums.difference, -25)));
  const auto all = sums.expected([](std::int64_t x, std::int64_t y) {
    return !left_out(x + y, 10) && !left_out(x - y, -20) && x + y < 60 && x - y > -25;
  });
  CHECK(sums.enumerated() == all);
  CHECK(sums.listed() == all);
}

TEST_CASE("constrained sums: two of them that are one or differ") {
  for (const bool equal : {true, false}) {
    CAPTURE(equal);
    ComparedSums sums;
    sums.leave_out(sums.sum, 0);
    sums.leave_out(sums.difference, 0);
    const NodeId same = sums.graph.apply(
        Op::kEqInt,
        {sums.sum, sums.graph.apply(Op::kAdd, {sums.difference, sums.graph.constant(std::int64_t{6})})});
    sums.conditions.push_back(equal ? same : sums.graph.negation(same));
    const auto all = sums.expected([&](std::int64_t x, std::int64_t y) {
      return !left_out(x + y, 0) && !left_out(x - y, 0) && (x + y == x - y + 6) == equal;
    });
    CHECK(sums.enumerated() == all);
    CHECK(sums.listed() == all);
  }
}

TEST_CASE("constrained sums: of literals as many as there are sums") {
  Circuit circuit;
  struct Count : ClauseSink {
    void clause(std::span<const int>) override { ++clauses; }
    std::size_t clauses = 0;
  } count;
  Cnf cnf(circuit, count);
  const auto input = [&](std::int64_t size) {
    OrderEncodedInt made = constant_order(0);
    for (std::int64_t value = 1; value < size; ++value)
      made.values.push_back(value), made.reached.push_back(circuit.input());
    return made;
  };
  const OrderEncodedInt sum = constrained_sum(circuit, cnf, input(4), input(3));
  CHECK(sum.values == std::vector<std::int64_t>{0, 1, 2, 3, 4, 5});
  CHECK(sum.reached.size() == 5);
  CHECK(count.clauses == 4 + 2 * (4 * 3 - 1));  // all but those of the lowest and of the highest pair
}

}  // namespace solitaire
