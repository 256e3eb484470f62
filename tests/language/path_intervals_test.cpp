// What is known of ints on a path is true of every execution that comes there, for random conditions and
// random ints that are computed under them.
#include "solitaire/run/path_intervals.h"

#include <doctest/doctest.h>
#include <random>
#include <string>
#include <vector>

#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

/// Three choices, ints that are computed of them on a path, and conditions that hold on it.
class RandomPath {
 public:
  Graph graph;
  PathIntervals facts{&graph};
  std::vector<NodeId> assumed;

  explicit RandomPath(std::uint64_t seed) : random_(seed) {
    for (std::size_t i = 0; i < 3; ++i) {
      const AddressId address = addresses_.site(addresses_.root(), std::to_string(i));
      ints_.push_back(graph.choice({address, Distribution::range(-2, 4)}));
    }
    for (const std::int64_t each : {-1, 1, 3}) ints_.push_back(graph.constant(each));
  }

  void compute() {
    const Op ops[] = {Op::kAdd, Op::kSub, Op::kMul, Op::kDiv, Op::kMod,
                      Op::kMin, Op::kMax, Op::kAbs, Op::kNeg};
    const Op op = ops[random_() % std::size(ops)];
    const NodeId a = some_int(), b = some_int();
    if ((op == Op::kDiv || op == Op::kMod) && graph.node(b).interval.contains(0)) return;
    const NodeId made = operation(op).arity == 1 ? graph.apply(op, {a}) : graph.apply(op, {a, b});
    facts.derive(made);
    ints_.push_back(made);
  }

  NodeId condition() {
    const Op ops[] = {Op::kEqInt, Op::kLtInt, Op::kLeInt};
    const NodeId made = graph.apply(ops[random_() % std::size(ops)], {some_int(), some_int()});
    return random_() % 2 == 0 ? made : graph.negation(made);
  }

  void assume() {
    const NodeId holds = condition();
    facts.assume(holds, true);
    assumed.push_back(holds);
  }

  /// Counts the executions of this path in which the condition holds, and those in which it does not.
  std::pair<int, int> count(NodeId condition) const {
    std::pair<int, int> counts;
    for (int i = 0; i < 7 * 7 * 7; ++i) {
      const int values[] = {i % 7 - 2, i / 7 % 7 - 2, i / 49 - 2};
      Assignment assignment(graph,
                            [&](std::size_t variable) { return Scalar::of(std::int64_t{values[variable]}); });
      bool here = true;
      for (const NodeId each : assumed) here = here && assignment.holds(each);
      if (here) ++(assignment.holds(condition) ? counts.first : counts.second);
    }
    return counts;
  }

 private:
  NodeId some_int() { return ints_[random_() % ints_.size()]; }

  std::mt19937_64 random_;
  AddressTable addresses_;
  std::vector<NodeId> ints_;
};

/// Returns 1 if the facts decide a random condition. It then has to be so in all executions of the path.
int check_decision(RandomPath& path) {
  const NodeId condition = path.condition();
  const auto decided = path.facts.decide(condition);
  if (!decided) return 0;
  const auto [holding, failing] = path.count(condition);
  CHECK((*decided ? failing : holding) == 0);
  return condition == kTrue || condition == kFalse ? 0 : 1;
}

TEST_CASE("path intervals: what they decide is so in every execution of the path") {
  int decided = 0;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    RandomPath path(seed);
    for (int i = 0; i < 4; ++i) path.compute();
    path.assume();
    const std::size_t outside = path.facts.size(), assumed = path.assumed.size();
    path.assume();
    for (int i = 0; i < 6; ++i) path.compute();
    for (int i = 0; i < 20; ++i) decided += check_decision(path);
    const std::size_t hidden = path.facts.hide();
    if (!path.graph.node(path.assumed.front()).is_constant())
      CHECK_FALSE(path.facts.decide(path.assumed.front()));
    path.facts.show_from(hidden);
    path.facts.drop_from(outside);
    path.assumed.resize(assumed);
    for (int i = 0; i < 20; ++i) decided += check_decision(path);
  }
  CHECK(decided > 100);
}

TEST_CASE(
    "path intervals: an int that is computed of narrowed ones is narrowed, until its path joins others") {
  Graph graph;
  AddressTable addresses;
  const NodeId n = graph.choice({addresses.site(addresses.root(), "n"), Distribution::range(-1, 2)});
  const NodeId m = graph.choice({addresses.site(addresses.root(), "m"), Distribution::range(1, 4)});
  PathIntervals facts(&graph);
  facts.assume(graph.apply(Op::kLtInt, {graph.constant(std::int64_t{0}), n}), true);
  const std::size_t before = facts.size();
  const NodeId rest = graph.apply(Op::kMod, {n, m});
  const NodeId is_three = graph.apply(Op::kEqInt, {rest, graph.constant(std::int64_t{3})});
  CHECK_FALSE(facts.decide(is_three));
  facts.derive(rest);
  CHECK(facts.decide(is_three) == false);
  facts.drop_from(before);
  CHECK_FALSE(facts.decide(is_three));
}

TEST_CASE("path intervals: a conjunction that shares its parts takes no longer than its nodes") {
  AddressTable addresses;
  Graph graph;
  std::uint64_t number = 0;
  const auto flip = [&] {
    const AddressId address = addresses.site(addresses.root(), std::to_string(number++));
    const NodeId drawn = graph.choice({address, Distribution::range(0, 1)});
    return graph.apply(Op::kEqInt, {drawn, graph.constant(std::int64_t{1})});
  };
  const NodeId x = graph.choice({addresses.site(addresses.root(), "x"), Distribution::range(0, 9)});
  NodeId all = graph.apply(Op::kLtInt, {x, graph.constant(std::int64_t{3})});
  for (int level = 0; level < 100; ++level)  // 2^100 ways lead down
    all = graph.conjunction(graph.conjunction(all, flip()), graph.conjunction(all, flip()));
  PathIntervals facts(&graph);
  facts.assume(all, true);
  CHECK(facts.decide(graph.apply(Op::kLtInt, {x, graph.constant(std::int64_t{3})})) == true);
  facts.assume(graph.negation(graph.apply(Op::kLtInt, {x, graph.constant(std::int64_t{2})})), true);
  CHECK(facts.decide(graph.apply(Op::kEqInt, {x, graph.constant(std::int64_t{2})})) == true);
}

}  // namespace
}  // namespace solitaire
