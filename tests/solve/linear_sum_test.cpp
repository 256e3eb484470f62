// A linear sum is worth what the nodes are worth that it was read from.
#include "engines/solve/conclusions/linear_sum.h"

#include <doctest/doctest.h>
#include <random>
#include <string>
#include <vector>

#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

/// Ints and bools, and random sums of them.
class RandomSums {
 public:
  explicit RandomSums(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 6; ++i) {
      const AddressId address = addresses_.address("x" + std::to_string(i));
      ints_.push_back(graph.choice({address, Distribution::range(-3, 4)}));
      bools_.push_back(graph.apply(Op::kLtInt, {ints_.back(), graph.constant(std::int64_t{1})}));
    }
  }

  NodeId sum(int depth) {
    if (depth == 0) return any(ints_);
    const NodeId a = sum(depth - 1);
    switch (number(0, 4)) {
      case 0:
        return graph.apply(Op::kAdd, {a, sum(depth - 1)});
      case 1:
        return graph.apply(Op::kSub, {a, sum(depth - 1)});
      case 2:
        return graph.apply(Op::kNeg, {a});
      case 3:
        return graph.apply(Op::kMul, {a, graph.constant(number(-3, 3))});
      default:
        return graph.apply(Op::kAdd, {a, weighed()});
    }
  }

  std::int64_t number(std::int64_t lo, std::int64_t hi) {
    return std::uniform_int_distribution<std::int64_t>(lo, hi)(random_);
  }

  Graph graph;

 private:
  NodeId weighed() {
    return graph.apply(Op::kIteInt,
                       {any(bools_), graph.constant(number(-9, 9)), graph.constant(number(-9, 9))});
  }
  NodeId any(const std::vector<NodeId>& nodes) {
    return nodes[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(nodes.size()) - 1))];
  }

  std::mt19937_64 random_;
  AddressTable addresses_;
  std::vector<NodeId> ints_, bools_;
};

std::int64_t worth(const LinearSum& sum, const Graph& graph, Assignment& values) {
  std::int64_t all = sum.constant();
  for (const LinearSum::Term& term : sum.terms()) {
    const bool is_bool = graph.node(term.node).type() == Type::kBool;
    const std::int64_t value = is_bool ? values.holds(term.node) : values.value(term.node)->i;
    CHECK(term.range.contains(value));
    all += term.factor * value;
  }
  return all;
}

TEST_CASE("linear sum: it is worth what its nodes are, whatever the choices are") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    RandomSums made(seed);
    const NodeId one = made.sum(3), other = made.sum(2);
    LinearSum sum(made.graph);
    REQUIRE(sum.add(one, 2));
    REQUIRE(sum.add(other, -3));
    for (int round = 0; round < 5; ++round) {
      Assignment values(made.graph, [&](std::size_t) { return Scalar::of(made.number(-3, 4)); });
      CHECK(worth(sum, made.graph, values) == 2 * values.value(one)->i - 3 * values.value(other)->i);
    }
  }
}

TEST_CASE("linear sum: numbers that could leave 64 bits are not added up") {
  Graph graph;
  AddressTable addresses;
  const NodeId small = graph.choice({addresses.address("small"), Distribution::range(0, 1)});
  const NodeId large =
      graph.choice({addresses.address("large"), Distribution::range(0, std::int64_t{1} << 31)});
  CHECK_FALSE(LinearSum(graph).add(large, 1));
  CHECK_FALSE(LinearSum(graph).add(small, std::int64_t{1} << 31));
  CHECK(LinearSum(graph).add(small, std::int64_t{1} << 30));
}

}  // namespace
}  // namespace solitaire
