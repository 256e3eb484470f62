// Sums that ask for more than others allow: what is found is true, by trying all values, and is found where
// it is plain.
#include "engines/solve/conclusions/sum_conflict.h"

#include <doctest/doctest.h>
#include <random>

#include "tests/solve/all_values.h"
#include "tests/support/command.h"
#include "tests/support/program_run.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

/// A graph with choices, and comparisons of sums of them.
struct Sums {
  NodeId number(std::int64_t value) { return graph.constant(value); }
  NodeId choice(std::int64_t lo, std::int64_t hi) {
    const AddressId address = addresses.address("x" + std::to_string(graph.variables().size()));
    return graph.choice({address, Distribution::range(lo, hi)});
  }
  NodeId sum(const std::vector<NodeId>& terms) {
    NodeId total = number(0);
    for (const NodeId term : terms) total = graph.apply(Op::kAdd, {total, term});
    return total;
  }
  NodeId is(NodeId a, std::int64_t value) { return graph.apply(Op::kEqInt, {a, number(value)}); }
  NodeId counted(NodeId condition, std::int64_t weight) {
    return graph.phi(condition, number(weight), number(0));
  }
  void require(NodeId condition) { conditions.push_back(condition); }
  void at_most(NodeId a, NodeId b) { require(graph.apply(Op::kLeInt, {a, b})); }
  std::optional<OverFull> found() {
    return find_sum_conflict(graph, find_separations(graph, conditions).comparisons);
  }

  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> conditions;
};

/// `guests` sit in one of `seats` each, written as a sum for each guest and for each seat.
Sums seats_by_sums(std::size_t guests, std::int64_t seats) {
  Sums made;
  std::vector<NodeId> chosen;
  for (std::size_t i = 0; i < guests; ++i) chosen.push_back(made.choice(1, seats));
  for (std::int64_t seat = 1; seat <= seats; ++seat) {
    std::vector<NodeId> here;
    for (const NodeId guest : chosen) here.push_back(made.counted(made.is(guest, seat), 1));
    made.at_most(made.sum(here), made.number(1));
  }
  return made;
}

/// Items of these weights are packed into boxes that hold `most` each, of which only the first `boxes` may be
/// used, and there are more.
Sums packing(const std::vector<std::int64_t>& weights, std::int64_t most, std::int64_t boxes) {
  Sums made;
  const NodeId used = made.choice(1, 5);
  std::vector<NodeId> box;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    box.push_back(made.choice(0, 4));
    made.require(made.graph.apply(Op::kLtInt, {box.back(), used}));
  }
  for (std::int64_t k = 0; k < 5; ++k) {
    std::vector<NodeId> here;
    for (std::size_t i = 0; i < weights.size(); ++i)
      here.push_back(made.counted(made.is(box[i], k), weights[i]));
    made.at_most(made.sum(here), made.number(most));
  }
  made.at_most(used, made.number(boxes));
  return made;
}

}  // namespace

TEST_CASE("sum conflict: a roster that asks for more turns than there are") {
  for (const std::int64_t asked : {4, 5}) {
    Sums roster;
    std::vector<std::vector<NodeId>> days(7);
    for (int nurse = 0; nurse < 8; ++nurse) {
      std::vector<NodeId> turns;
      for (std::vector<NodeId>& day : days) {
        turns.push_back(roster.choice(0, 1));
        day.push_back(turns.back());
      }
      roster.at_most(roster.sum(turns), roster.number(4));
    }
    for (const std::vector<NodeId>& day : days) roster.at_most(roster.number(asked), roster.sum(day));
    const std::optional<OverFull> found = roster.found();
    REQUIRE(found.has_value() == (asked == 5));
    if (!found) continue;
    CHECK(found->measure == OverFull::Measure::kSum);
    CHECK(found->needed == 35);
    CHECK(found->available == 32);
    CHECK(found->conditions.size() == 15);
  }
}

TEST_CASE("sum conflict: each guest has a seat, and each seat a guest at most") {
  CHECK(!seats_by_sums(9, 9).found());
  const std::optional<OverFull> found = seats_by_sums(10, 9).found();
  REQUIRE(found);
  CHECK(found->needed == 10);
  CHECK(found->available == 9);
  CHECK(found->conditions.size() == 9);  // that each guest sits is no condition, but follows from the range
}

TEST_CASE("sum conflict: what items weigh together is more than the boxes in use hold") {
  const std::vector<std::int64_t> weights{6, 5, 5, 4};
  CHECK(!packing(weights, 10, 2).found());
  Sums full = packing(weights, 9, 2);
  const std::optional<OverFull> found = full.found();
  REQUIRE(found);
  CHECK(found->needed == 20);
  CHECK(found->available == 18);
  CHECK(found->conditions.size() == 2 + 4 + 1);  // two boxes, each item's box, and how many are used
  CHECK(!can_hold(full.graph, found->conditions));
}

TEST_CASE("sum conflict: what is found can never hold, and that is often") {
  std::size_t conflicts = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t bound) { return static_cast<std::int64_t>(random() % bound); };
    Sums sums;
    std::vector<NodeId> ints;
    for (int i = 0; i < 4; ++i) {
      const std::int64_t low = below(3) - 1;
      ints.push_back(sums.choice(low, low + 1 + below(3)));
    }
    for (int i = 0; i < 5; ++i) {
      std::vector<NodeId> terms;
      for (const NodeId term : ints) {
        const std::int64_t factor = below(5) - 2;
        if (below(4) == 0) {
          terms.push_back(sums.counted(sums.is(term, below(4) - 1), factor));
        } else if (factor != 0) {
          terms.push_back(sums.graph.apply(Op::kMul, {term, sums.number(factor)}));
        }
      }
      const NodeId limit =
          below(3) == 0 ? ints[static_cast<std::size_t>(below(4))] : sums.number(below(9) - 6);
      const Op op = below(4) == 0 ? Op::kEqInt : below(2) == 0 ? Op::kLeInt : Op::kLtInt;
      const NodeId comparison = sums.graph.apply(op, {sums.sum(terms), limit});
      sums.require(op != Op::kEqInt && below(3) == 0 ? sums.graph.negation(comparison) : comparison);
    }
    const std::optional<OverFull> found = sums.found();
    if (!found) continue;
    ++conflicts;
    CHECK(found->needed > found->available);
    REQUIRE(!can_hold(sums.graph, found->conditions));
  }
  CHECK(conflicts > 40);
}

TEST_CASE("sum conflict: the proof comes at once, by either solver, with its reason") {
  const Workplace place;
  const std::string roster =
      place.file("roster.sol",
                 "works = [[flip() for d in 1..7] for i in 1..8];\n"
                 "for w in works: assert(sum([cond(x, 1, 0) for x in w]) <= 4);\n"
                 "for d in 0..6: assert(sum([cond(w[d], 1, 0) for w in works]) >= 5);\nreturn 1;\n");
  const std::string packing =
      place.file("packing.sol",
                 "items = [57, 49, 46, 44, 42, 38, 33, 31, 29, 27, 25, 23, 19, 17, 14, 12, 9, 8];\nbin = "
                 "[range(0, 17) for i in items];\nused = range(1, 18);\n"
                 "for b in bin: assert(b < used);\n"
                 "for k in 0..17: assert(sum([cond(bin[i] == k, items[i], 0) for i in 0..17]) <= 100);\n"
                 "minimize(used);\nreturn used;\n");
  for (const char* engine : {"cadical", "z3"})
    CHECK(run_solitaire({"solve", roster, "--engine", engine, "--timeout", "20"}).status == 1);
  const Outcome reason = run_solitaire({"explain", roster, "--timeout", "30"});
  CHECK(
      reason.out.find("the reason: added up, these conditions ask for 35 at least, and allow 32 at most\n") !=
      std::string::npos);
  const Outcome packed = run_solitaire({"solve", packing, "--timeout", "30"});
  CHECK(packed.out.find("cost 6, proved the best left") != std::string::npos);  // they weigh 523
  CHECK(packed.out.find("not proved") == std::string::npos);
}

}  // namespace solitaire
