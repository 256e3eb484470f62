// A search that tries several ways, each for a while, says what one that tries a single way says.
#include "smt/nearby_then_cadical.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <vector>

#include "smt/sat/cadical_solver.h"
#include "tests/smt/random_clauses.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

constexpr int kTruths = 60;

/// Bools, and clauses of them that about half of the time have a model.
struct Truths {
  explicit Truths(std::mt19937_64& random) {
    for (int i = 0; i < kTruths; ++i) {
      const AddressId address = addresses.address("b" + std::to_string(i));
      const NodeId choice = graph.choice({address, Distribution::range(0, 1)});
      conditions.push_back(graph.apply(Op::kEqInt, {choice, graph.constant(std::int64_t{1})}));
    }
    for (int i = 0; i < kTruths * 21 / 5; ++i)
      clauses.push_back(nodes_of(random_clause(random, kTruths, 3, 1)));
  }

  std::vector<NodeId> nodes_of(const Clause& literals) {
    std::vector<NodeId> nodes;
    for (const int literal : literals) {
      const NodeId condition = conditions[static_cast<std::size_t>(std::abs(literal) - 1)];
      nodes.push_back(literal > 0 ? condition : graph.negation(condition));
    }
    return nodes;
  }

  bool is_model(Solver& solver, const std::vector<NodeId>& assumed) {
    Assignment model(graph, [&](std::size_t variable) { return Scalar::of(solver.value(variable)); });
    const auto holds = [&](NodeId condition) { return model.holds(condition); };
    return std::ranges::all_of(assumed, holds) && std::ranges::all_of(clauses, [&](const auto& clause) {
             return std::ranges::any_of(clause, holds);
           });
  }

  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> conditions;
  std::vector<std::vector<NodeId>> clauses;
};

}  // namespace

TEST_CASE("nearby then cadical: to give up on every way at once changes no answer") {
  std::mt19937_64 random(1);
  const StopSignal never;
  int with = 0, without = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Truths truths(random);
    const auto plain = make_cadical_solver(truths.graph);
    const auto hasty = make_nearby_then_cadical(truths.graph, {seed, false, 1, 1});
    for (const std::vector<NodeId>& clause : truths.clauses) {
      plain->add_clause(clause);
      hasty->add_clause(clause);
    }
    for (int round = 0; round < 12; ++round) {
      const std::vector<NodeId> assumed = truths.nodes_of(random_clause(random, kTruths, 2, 3));
      for (std::size_t i = 0; i < kTruths; ++i) hasty->suggest(i, static_cast<std::int64_t>(random() % 2));
      const Verdict verdict = hasty->check(assumed, never);
      REQUIRE(verdict == plain->check(assumed, never));
      if (verdict == Verdict::kSatisfiable) CHECK(truths.is_model(*hasty, assumed));
      ++(verdict == Verdict::kSatisfiable ? with : without);
    }
  }
  CHECK(with > 50);
  CHECK(without > 50);
}

TEST_CASE("nearby then cadical: a signal on one of the ways leaves the question open") {
  std::mt19937_64 random(2);
  Truths truths(random);
  const auto solver = make_nearby_then_cadical(truths.graph, {});
  for (const std::vector<NodeId>& clause : truths.clauses) solver->add_clause(clause);
  StopSignal stopped;
  stopped.request();
  for (std::size_t i = 0; i < kTruths; ++i) solver->suggest(i, 0);
  CHECK(solver->check({}, stopped) == Verdict::kStopped);
}

}  // namespace solitaire
