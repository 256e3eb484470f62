// Ints that differ and are as many as their values: what is said of them follows from what is required, by
// trying all values, and it is said where it is plain and nowhere else.
#include "engines/solve/conclusions/permutations.h"

#include <doctest/doctest.h>

#include "engines/solve/conclusions/sum_conflict.h"
#include "tests/solve/all_values.h"
#include "tracegraph/graph.h"

namespace solitaire {
namespace {

struct DifferentInts {
  NodeId add(std::int64_t lo, std::int64_t hi) {
    const AddressId address = addresses.address("x" + std::to_string(graph.variables().size()));
    return graph.choice({address, Distribution::range(lo, hi)});
  }
  NodeId plus(NodeId a, std::int64_t b) { return graph.apply(Op::kAdd, {a, graph.constant(b)}); }
  void differ(NodeId a, NodeId b) { conditions.push_back(graph.negation(graph.apply(Op::kEqInt, {a, b}))); }
  void all_differ(const std::vector<NodeId>& ints) {
    for (std::size_t i = 0; i < ints.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) differ(ints[i], ints[j]);
    }
  }

  /// Returns what is found, after a check that it follows.
  std::vector<NodeId> found() {
    const Permutations found = find_permutations(graph, find_separations(graph, conditions));
    std::vector<NodeId> implied = found.values;
    CHECK(found.taken.size() == found.values.size());
    for (const auto* more : {&found.taken, &found.sums})
      implied.insert(implied.end(), more->begin(), more->end());
    REQUIRE(can_hold(graph, conditions));
    for (const NodeId condition : implied) {
      std::vector<NodeId> broken = conditions;
      broken.push_back(graph.negation(condition));
      CHECK_FALSE(can_hold(graph, broken));
    }
    return found.values;
  }

  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> conditions;
};

}  // namespace

TEST_CASE("permutations: as many different ints as values") {
  DifferentInts ints;
  ints.all_differ({ints.add(2, 5), ints.add(2, 5), ints.add(2, 4), ints.add(3, 5)});
  CHECK(ints.found().size() == 4);
}

TEST_CASE("permutations: none where a value may be left, or two are not kept apart") {
  DifferentInts wide;
  wide.all_differ({wide.add(1, 4), wide.add(1, 4), wide.add(1, 4)});
  CHECK(wide.found().empty());
  DifferentInts open;
  const NodeId a = open.add(1, 3), b = open.add(1, 3), c = open.add(1, 3);
  open.differ(a, b);
  open.differ(b, c);
  CHECK(open.found().empty());
}

TEST_CASE("permutations: a condition narrows the values") {
  DifferentInts ints;
  const NodeId a = ints.add(1, 9), b = ints.add(1, 3), c = ints.add(1, 3);
  ints.all_differ({a, b, c});
  CHECK(ints.found().empty());
  ints.conditions.push_back(ints.graph.apply(Op::kLtInt, {a, ints.graph.constant(std::int64_t{4})}));
  CHECK(ints.found().size() == 3);
}

TEST_CASE("permutations: to compare ints that are looked up is no longer needed") {
  for (const bool looked_up : {true, false}) {
    DifferentInts ints;
    std::vector<NodeId> members;
    for (std::int64_t i = 0; i < 3; ++i) {
      const NodeId index = ints.add(0, 2);
      const auto is = [&](std::int64_t place) {
        return ints.graph.apply(Op::kEqInt, {index, ints.graph.constant(place)});
      };
      const auto constant = [&](std::int64_t value) { return ints.graph.constant(value); };
      const NodeId element = ints.graph.phi(is(0), constant((2 * i) % 3),
                                            ints.graph.phi(is(1), constant(1), constant((2 * i + 2) % 3)));
      members.push_back(looked_up ? element : index);
    }
    ints.all_differ(members);
    CHECK(ints.found().size() == 3);
    const Permutations found = find_permutations(ints.graph, find_separations(ints.graph, ints.conditions));
    CHECK(found.ruled_out.size() == (looked_up ? 3 : 0));
    for (const NodeId equation : found.ruled_out) {
      std::vector<NodeId> conditions = found.values;
      conditions.push_back(equation);
      CHECK_FALSE(can_hold(ints.graph, conditions));
    }
  }
}

TEST_CASE("permutations: rows and columns of a square (slow)") {
  DifferentInts ints;
  std::vector<std::vector<NodeId>> rows(3), columns(3);
  for (std::size_t i = 0; i < 9; ++i) {
    const NodeId cell = ints.add(0, 2);
    rows[i / 3].push_back(cell);
    columns[i % 3].push_back(cell);
  }
  for (const auto& lines : {rows, columns}) {
    for (const auto& line : lines) ints.all_differ(line);
  }
  CHECK(ints.found().size() == 18);
}

namespace {

/// Two cards of each number up to `numbers`, as many cards apart as the number says, in a row without gaps.
DifferentInts cards(std::int64_t numbers) {
  DifferentInts ints;
  std::vector<NodeId> places;
  for (std::int64_t number = 1; number <= numbers; ++number) {
    const NodeId first = ints.add(0, 2 * numbers - 2 - number);
    places.push_back(first);
    places.push_back(ints.plus(first, number + 1));
  }
  ints.all_differ(places);
  return ints;
}

}  // namespace

TEST_CASE("permutations: ints with offsets, as two cards of each number with as many between them") {
  CHECK(cards(3).found().size() == 6);
}

TEST_CASE("permutations: what they add up to shows that there are none") {
  for (const std::int64_t numbers : {3, 4, 5, 6, 7}) {  // the first cards' places add up to half a number
    CAPTURE(numbers);
    DifferentInts ints = cards(numbers);
    std::vector<SignedNode> sums;
    for (const NodeId sum : find_permutations(ints.graph, find_separations(ints.graph, ints.conditions)).sums)
      sums.push_back({sum});
    REQUIRE(sums.size() == 1);
    CHECK(find_sum_conflict(ints.graph, sums).has_value() == (numbers == 5 || numbers == 6));
  }
}

}  // namespace solitaire
