// Conditions on one choice or two that are written as tables: they hold for exactly the values for which the
// operation table says so, and so do their negations, alone and in other conditions.
#include "smt/sat/truth_table.h"

#include <doctest/doctest.h>
#include <functional>
#include <random>
#include <set>
#include <vector>

#include "smt/cdcl/enumerator.h"
#include "smt/sat/cadical_solver.h"
#include "smt/sat/small_cones.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

using TabledValues = std::vector<std::int64_t>;

/// A graph with choices of few values and without gaps or with them.
struct TabledInts {
  explicit TabledInts(const std::vector<Distribution>& domains) {
    for (const Distribution& domain : domains) {
      const AddressId address = addresses.address("x" + std::to_string(nodes.size()));
      nodes.push_back(graph.choice({address, domain}));
    }
  }

  NodeId apply(Op op, NodeId a, NodeId b) { return graph.apply(op, {a, b}); }
  NodeId constant(std::int64_t value) { return graph.constant(value); }

  /// Returns the values of the choices under which a condition holds.
  std::set<TabledValues> holding(NodeId condition) const {
    std::set<TabledValues> found;
    TabledValues values(nodes.size());
    const std::function<void(std::size_t)> each = [&](std::size_t at) {
      if (at < nodes.size()) {
        const Distribution& domain = graph.variables()[at].domain;
        for (std::uint64_t i = 0; i < domain.size(); ++i) values[at] = domain.value(i), each(at + 1);
        return;
      }
      Assignment assignment(graph, [&](std::size_t variable) { return Scalar::of(values[variable]); });
      if (assignment.holds(condition)) found.insert(values);
    };
    each(0);
    return found;
  }

  /// Returns the same as the enumerator has it.
  std::set<TabledValues> enumerated(NodeId condition) const {
    std::vector<std::size_t> choices(nodes.size());
    for (std::size_t i = 0; i < choices.size(); ++i) choices[i] = i;
    Enumerator enumerator(graph, {&condition, 1}, choices);
    std::set<TabledValues> found;
    const StopSignal never;
    while (enumerator.next(never) == Enumerator::Outcome::kFound) {
      TabledValues values;
      for (const std::size_t choice : choices) values.push_back(enumerator.value(choice));
      CHECK(found.insert(values).second);
    }
    return found;
  }

  /// Returns the same as CaDiCaL has it, which is asked for one model after the other.
  std::set<TabledValues> listed(NodeId condition) {
    const auto solver = make_cadical_solver(graph, 0);
    solver->add_clause({&condition, 1});
    std::set<TabledValues> found;
    const StopSignal never;
    while (solver->check({}, never) == Verdict::kSatisfiable) {
      TabledValues values;
      std::vector<NodeId> other;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        values.push_back(solver->value(i));
        other.push_back(graph.negation(apply(Op::kEqInt, nodes[i], constant(values.back()))));
      }
      CHECK(found.insert(values).second);
      solver->add_clause(other);
    }
    return found;
  }

  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> nodes;
};

void check_tabled(TabledInts& choices, NodeId condition) {
  for (const NodeId each : {condition, choices.graph.negation(condition)}) {
    const std::set<TabledValues> expected = choices.holding(each);
    CHECK(choices.enumerated(each) == expected);
    CHECK(choices.listed(each) == expected);
  }
}

const Distribution kTabledCell{0, 24, 1, {}}, kTabledSteps{-6, 9, 3, {}}, kTabledSigned{-4, 5, 1, {}},
    kTabledBit{0, 1, 1, {}};

}  // namespace

TEST_CASE("truth tables: knights that jump from cell to cell") {
  TabledInts choices({kTabledCell, kTabledCell});
  const auto apart = [&](Op op) {
    const NodeId five = choices.constant(5);
    const NodeId difference = choices.apply(Op::kSub, choices.apply(op, choices.nodes[0], five),
                                            choices.apply(op, choices.nodes[1], five));
    return choices.graph.apply(Op::kAbs, {difference});
  };
  const NodeId product = choices.apply(Op::kMul, apart(Op::kMod), apart(Op::kDiv));
  const NodeId jump = choices.apply(Op::kEqInt, product, choices.constant(2));
  CHECK(choices.holding(jump).size() == 96);
  check_tabled(choices, jump);
}

TEST_CASE("truth tables: random conditions with products and remainders") {
  std::mt19937_64 random(7);
  for (const auto& domains :
       std::vector<std::vector<Distribution>>{{kTabledSigned, kTabledSteps},
                                              {kTabledSteps, kTabledBit},
                                              {kTabledSigned},
                                              {kTabledSigned, kTabledBit, kTabledSteps}}) {
    for (int round = 0; round < 30; ++round) {
      TabledInts choices(domains);
      const auto some = [&](const std::vector<NodeId>& of) { return of[random() % of.size()]; };
      std::vector<NodeId> ints = choices.nodes, bools;
      for (const std::int64_t each : {-2, 3, 5}) ints.push_back(choices.constant(each));
      for (int i = 0; i < 12; ++i) {
        const Op op = std::vector{Op::kMul, Op::kAdd, Op::kSub, Op::kMax}[random() % 4];
        const NodeId made = choices.apply(op, some(ints), some(ints));
        ints.push_back(
            choices.apply(Op::kMod, made, choices.constant(2 + static_cast<std::int64_t>(random() % 5))));
        const Op compares = std::vector{Op::kEqInt, Op::kLtInt, Op::kLeInt}[random() % 3];
        bools.push_back(choices.apply(compares, some(ints), some(ints)));
      }
      const NodeId both = choices.apply(Op::kAnd, some(bools), some(bools));
      check_tabled(choices, choices.apply(Op::kOr, both, choices.graph.negation(some(bools))));
    }
  }
}

TEST_CASE("truth tables: for conditions on two choices at most that need bits") {
  TabledInts choices({kTabledCell, kTabledCell, kTabledCell});
  const auto& x = choices.nodes;
  const auto remainder = [&](NodeId a) { return choices.apply(Op::kMod, a, choices.constant(7)); };
  const NodeId one = choices.apply(Op::kEqInt, remainder(x[0]), choices.constant(3));
  const NodeId two = choices.apply(Op::kLtInt, remainder(x[0]), x[1]);
  const NodeId three = choices.apply(Op::kAnd, two, choices.apply(Op::kLtInt, remainder(x[2]), x[1]));
  const NodeId ordered = choices.apply(Op::kLtInt, x[0], x[1]);
  SmallCones cones(choices.graph);
  cones.meet_new([&](NodeId node) { return choices.graph.node(node).op != Op::kMod; });
  CHECK(cones.tabled(one).size() == 1);
  CHECK(cones.tabled(two).size() == 2);
  CHECK(cones.tabled(three).empty());
  CHECK(cones.tabled(ordered).empty());
}

}  // namespace solitaire
