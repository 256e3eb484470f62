// The least cost by cores, held against trying all values.
#include "engines/solve/wishes/cost_cores.h"

#include <algorithm>
#include <bit>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <random>

#include "engines/tuning.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

using Values = std::vector<std::int64_t>;

/// Ints, values of them that are allowed, and a cost that is a sum of many terms.
struct Costs {
  explicit Costs(unsigned seed) : random(seed) {
    for (std::size_t i = 0; i < 5; ++i) {
      const AddressId address = addresses.address("x" + std::to_string(i));
      ints.push_back(graph.choice({address, Distribution::range(0, below(2) == 0 ? 1 : 3)}));
    }
    for (std::size_t i = 0; i < tuning::kManyCosts + 4; ++i)
      cost = graph.apply(Op::kAdd, {cost, below(4) == 0 ? multiple() : wish()});
    Values values(ints.size());
    allow_some(values, 0);
  }

  std::int64_t below(std::int64_t end) { return static_cast<std::int64_t>(random()) % end; }
  NodeId some_int() { return ints[static_cast<std::size_t>(below(static_cast<std::int64_t>(ints.size())))]; }
  NodeId multiple() { return graph.apply(Op::kMul, {some_int(), graph.constant(below(5) - 2)}); }
  NodeId wish() {
    const NodeId condition = graph.apply(Op::kEqInt, {some_int(), graph.constant(below(4))});
    const NodeId other = graph.apply(Op::kLtInt, {some_int(), some_int()});
    return graph.phi(graph.disjunction(condition, other), graph.constant(below(7) - 3),
                     graph.constant(std::int64_t{0}));
  }
  void allow_some(Values& values, std::size_t i) {
    if (i == ints.size()) {
      if (below(6) == 0) allowed.push_back(values);
      return;
    }
    for (values[i] = 0; values[i] <= graph.node(ints[i]).interval.hi; ++values[i]) allow_some(values, i + 1);
  }

  std::int64_t cost_of(const Values& values) { return assignment(values).value(cost)->i; }
  bool hold(const Values& values, const std::vector<NodeId>& conditions) {
    Assignment made = assignment(values);
    return std::ranges::all_of(conditions, [&](NodeId condition) { return made.holds(condition); });
  }
  const Values* found(const std::vector<NodeId>& conditions) {
    const auto at =
        std::ranges::find_if(allowed, [&](const Values& values) { return hold(values, conditions); });
    return at == allowed.end() ? nullptr : &*at;
  }
  /// Leaves out what is not needed, or only some of it.
  std::vector<NodeId> core_of(std::vector<NodeId> conditions) {
    for (std::size_t i = 0; i < conditions.size();) {
      std::vector<NodeId> fewer = conditions;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      if (below(4) == 0 || found(fewer) != nullptr) {
        ++i;
      } else {
        conditions = std::move(fewer);
      }
    }
    return conditions;
  }

  Assignment assignment(const Values& values) {
    return Assignment(graph, [values](std::size_t variable) { return Scalar::of(values[variable]); });
  }

  std::mt19937 random;
  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> ints;
  NodeId cost = graph.constant(std::int64_t{0});
  std::vector<Values> allowed;
};

TEST_CASE("cost cores: what is proved is never more than the least cost, and comes to it") {
  int raised = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    Costs costs(seed);
    if (costs.allowed.empty()) continue;
    std::int64_t least = INT64_MAX;
    for (const Values& values : costs.allowed) least = std::min(least, costs.cost_of(values));
    auto cores = CostCores::of(costs.graph, costs.cost);
    if (!cores) continue;  // terms that fell together
    while (true) {
      REQUIRE(cores->least() <= least);
      const std::vector<NodeId> wanted = cores->wanted();
      const Values* found = costs.found(wanted);
      if (found == nullptr) {
        REQUIRE(cores->raise(costs.core_of(wanted)));
        ++raised;
      } else if (cores->wants_all()) {
        CHECK(costs.cost_of(*found) == least);
        CHECK(cores->least() == least);
        break;
      } else {
        cores->want_more();
      }
    }
  }
  CHECK(raised > 300);
}

TEST_CASE("cost cores: a core without anything wanted raises nothing") {
  Costs costs(1);
  auto cores = CostCores::of(costs.graph, costs.cost);
  REQUIRE(cores.has_value());
  const std::int64_t least = cores->least();
  CHECK(!cores->raise(std::vector{kTrue}));
  CHECK(cores->least() == least);
}

TEST_CASE("cost cores: a cost of few terms, or of terms with many values, is left to others") {
  Graph graph;
  AddressTable addresses;
  const auto sum = [&](std::size_t terms, std::int64_t most) {
    NodeId total = graph.constant(std::int64_t{0});
    for (std::size_t i = 0; i < terms; ++i) {
      const AddressId address = addresses.address(fmt::format("{} {}", most, i));
      total = graph.apply(Op::kAdd, {total, graph.choice({address, Distribution::range(0, most)})});
    }
    return total;
  };
  CHECK(CostCores::of(graph, sum(tuning::kManyCosts, tuning::kMostStepsOfCost)).has_value());
  CHECK(!CostCores::of(graph, sum(tuning::kManyCosts - 1, 3)).has_value());
  CHECK(!CostCores::of(graph, sum(tuning::kManyCosts, tuning::kMostStepsOfCost + 1)).has_value());
}

TEST_CASE("tally: its conditions say how many of some hold") {
  for (std::size_t count = 1; count <= 6; ++count) {
    Graph graph;
    AddressTable addresses;
    std::vector<NodeId> conditions;
    for (std::size_t i = 0; i < count; ++i) {
      const NodeId flip =
          graph.choice({addresses.address("b" + std::to_string(i)), Distribution::range(0, 1)});
      conditions.push_back(graph.apply(Op::kEqInt, {flip, graph.constant(std::int64_t{1})}));
    }
    const auto tally = Tally::of(conditions);
    CHECK(tally->most() == count);
    for (std::uint64_t bits = 0; bits < std::uint64_t{1} << count; ++bits) {
      Assignment assignment(
          graph, [bits](std::size_t i) { return Scalar::of(static_cast<std::int64_t>(bits >> i & 1)); });
      for (std::size_t number = 0; number <= count; ++number)
        CHECK(assignment.holds(tally->at_least(graph, number)) ==
              (std::popcount(bits) >= static_cast<int>(number)));
    }
  }
}

}  // namespace
}  // namespace solitaire
