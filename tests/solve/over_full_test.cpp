// Things that need more room than there is: what is found is true, by trying all values, and is found where
// it is plain.
#include "engines/solve/conclusions/over_full.h"

#include <doctest/doctest.h>
#include <random>

#include "tests/solve/all_values.h"
#include "tests/support/command.h"
#include "tests/support/program_run.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

/// A graph with choices, and conditions on them.
struct Layout {
  NodeId choice(std::int64_t lo, std::int64_t hi) {
    const AddressId address = addresses.address("x" + std::to_string(graph.variables().size()));
    return graph.choice({address, Distribution::range(lo, hi)});
  }
  NodeId plus(NodeId a, std::int64_t b) { return graph.apply(Op::kAdd, {a, graph.constant(b)}); }
  NodeId at_most(NodeId a, NodeId b) { return graph.apply(Op::kLeInt, {a, b}); }
  void differ(NodeId a, NodeId b) { conditions.push_back(graph.negation(graph.apply(Op::kEqInt, {a, b}))); }
  NodeId before(NodeId a, std::int64_t length, NodeId b) {  // in several of the ways in which programs say so
    if (length == 1 && random() % 2 == 0) return graph.apply(Op::kLtInt, {a, b});
    if (random() % 3 == 0) return graph.negation(graph.apply(Op::kLtInt, {b, plus(a, length)}));
    return at_most(plus(a, length), b);
  }
  NodeId any_order(NodeId a, std::int64_t a_length, NodeId b, std::int64_t b_length) {
    return graph.disjunction(before(a, a_length, b), before(b, b_length, a));
  }
  std::vector<OverFull> found() { return find_over_full(graph, conditions); }

  std::mt19937_64 random{1};
  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> conditions;
};

struct Box {
  NodeId x, y;
  std::int64_t w, d;
};

void keep_apart(Layout& layout, const Box& a, const Box& b) {
  const NodeId beside = layout.any_order(a.x, a.w, b.x, b.w);
  const NodeId behind = layout.any_order(a.y, a.d, b.y, b.d);
  layout.conditions.push_back(layout.graph.disjunction(beside, behind));
}

Layout boxes(std::size_t count, std::int64_t size, std::int64_t room) {
  Layout layout;
  std::vector<Box> all;
  for (std::size_t i = 0; i < count; ++i) {
    const NodeId x = layout.choice(0, room - size), y = layout.choice(0, room - size);
    for (const Box& other : all) keep_apart(layout, {x, y, size, size}, other);
    all.push_back({x, y, size, size});
  }
  return layout;
}

Layout seats(std::size_t count, std::int64_t places) {
  Layout layout;
  std::vector<NodeId> all;
  for (std::size_t i = 0; i < count; ++i) {
    const NodeId seat = layout.choice(1, places);
    for (const NodeId other : all) layout.differ(seat, other);
    all.push_back(seat);
  }
  return layout;
}

}  // namespace

TEST_CASE("over-full: more ints that differ than there are values") {
  CHECK(seats(10, 10).found().empty());
  Layout layout = seats(12, 10);
  const std::vector<OverFull> found = layout.found();
  REQUIRE(found.size() == 1);
  CHECK(found[0].things == 11);
  CHECK(found[0].needed == 11);
  CHECK(found[0].available == 10);
  CHECK(found[0].measure == OverFull::Measure::kLength);
  CHECK(found[0].conditions.size() == 55);
}

TEST_CASE("over-full: some of the ints lie among fewer values than all do") {
  Layout layout = seats(4, 9);
  std::vector<NodeId> few;
  for (int i = 0; i < 4; ++i) {
    few.push_back(layout.choice(5, 7));
    for (int j = 0; j < i; ++j) layout.differ(few[static_cast<std::size_t>(j)], few.back());
  }
  const std::vector<OverFull> found = layout.found();
  REQUIRE(found.size() == 1);
  CHECK(found[0].things == 4);
  CHECK(found[0].available == 3);
}

TEST_CASE("over-full: the areas of boxes are more than that of their room") {
  CHECK(boxes(16, 2, 8).found().empty());
  Layout layout = boxes(18, 2, 8);
  const std::vector<OverFull> found = layout.found();
  REQUIRE(found.size() == 1);
  CHECK(found[0].things == 17);
  CHECK(found[0].needed == 68);
  CHECK(found[0].available == 64);
  CHECK(found[0].measure == OverFull::Measure::kArea);
}

TEST_CASE("over-full: a room that conditions make small") {
  Layout layout;
  std::vector<Box> all;
  for (int i = 0; i < 5; ++i) {
    const NodeId x = layout.choice(0, 90), y = layout.choice(0, 90);
    for (const Box& other : all) keep_apart(layout, {x, y, 2, 2}, other);
    all.push_back({x, y, 2, 2});
    const NodeId width = layout.choice(3, 4);
    layout.conditions.push_back(layout.at_most(layout.plus(x, 2), width));
    layout.conditions.push_back(layout.at_most(y, layout.graph.constant(std::int64_t{2})));
  }
  const std::vector<OverFull> found = layout.found();
  REQUIRE(found.size() == 1);
  CHECK(found[0].needed == 20);
  CHECK(found[0].available == 16);
  CHECK(found[0].conditions.size() == 10 + 10);  // the ends take part
  layout.conditions.pop_back();
  CHECK(layout.found().empty());
}

TEST_CASE("over-full: what is found can never hold, and that is often") {
  std::size_t over_full = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    Layout layout;
    layout.random.seed(seed);
    const auto below = [&](std::uint64_t bound) {
      return static_cast<std::int64_t>(layout.random() % bound);
    };
    const bool flat = seed % 2 == 0;
    std::vector<Box> all;
    for (int i = 0; i < (flat ? 4 : 3); ++i) {
      const std::int64_t x = below(2), y = below(2);
      const Box box{layout.choice(x, x + 1 + below(2)), flat ? kTrue : layout.choice(y, y + 1 + below(2)),
                    1 + below(3), 1 + below(3)};
      for (const Box& other : all) {
        if (below(8) == 0) continue;
        if (flat) {
          layout.conditions.push_back(layout.any_order(box.x, box.w, other.x, other.w));
        } else {
          keep_apart(layout, box, other);
        }
      }
      all.push_back(box);
      if (below(3) == 0)
        layout.conditions.push_back(layout.at_most(box.x, layout.graph.constant(x + below(2))));
    }
    for (const OverFull& found : layout.found()) {
      ++over_full;
      CHECK(found.needed > found.available);
      REQUIRE(!can_hold(layout.graph, found.conditions));
    }
  }
  CHECK(over_full > 40);
}

TEST_CASE("over-full: the proof comes at once, by either solver, with its reason") {
  const Workplace place;
  const std::string tables =
      place.file("tables.sol",
                 "import \"std/layout.sol\";\n"
                 "tables = [Thing(\"table\", 2, 2, 0, range(0, 6), range(0, 6)) for i in 1..17];\n"
                 "assert(all_apart(tables));\nreturn 1;\n");
  const std::string seats = place.file(
      "seats.sol", "seats = [range(1, 30) for i in 1..31];\nassert(distinct(seats));\nreturn seats;\n");
  for (const char* engine : {"cadical", "z3"}) {
    for (const std::string& script : {tables, seats}) {
      CAPTURE(script);
      CHECK(run_solitaire({"solve", script, "--engine", engine, "--timeout", "20"}).status == 1);
    }
  }
  const Outcome tight = run_solitaire({"explain", tables, "--timeout", "30"});
  CHECK(tight.out.find(
            "the reason: 17 things that do not overlap need an area of 68, and lie within one of 64\n") !=
        std::string::npos);
  const Outcome crowded = run_solitaire({"explain", seats, "--timeout", "30"});
  CHECK(crowded.out.find("the reason: 31 ints that all differ lie among 30 values\n") != std::string::npos);
}

}  // namespace solitaire
