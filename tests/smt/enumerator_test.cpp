// Going through all models, from the lowest values of the choices on and from a model that is known, whether
// or not clauses are learned on the way.
#include "smt/cdcl/enumerator.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace solitaire {
namespace {

/// Ints from 0 on, and conditions on them.
class IntPuzzle {
 public:
  using Values = std::vector<std::int64_t>;

  Enumerator enumerator() const {
    std::vector<std::size_t> variables;
    for (std::size_t i = 0; i < ints_.size(); ++i) variables.push_back(i);
    return {graph_, conditions_, variables};
  }

  /// Returns the solutions that are left, in the order in which they come.
  std::vector<Values> rest(Enumerator& enumerator) const {
    const StopSignal never;
    std::vector<Values> solutions;
    while (enumerator.next(never) == Enumerator::Outcome::kFound) {
      Values& values = solutions.emplace_back();
      for (std::size_t i = 0; i < ints_.size(); ++i) values.push_back(enumerator.value(i));
    }
    CHECK(enumerator.next(never) == Enumerator::Outcome::kNone);
    return solutions;
  }

 protected:
  IntPuzzle(std::size_t count, std::int64_t last) {
    for (std::size_t i = 0; i < count; ++i)
      ints_.push_back(
          graph_.choice({addresses_.address("i" + std::to_string(i)), Distribution::range(0, last)}));
  }

  NodeId int_at(std::size_t i) const { return ints_[i]; }
  NodeId constant(std::int64_t value) { return graph_.constant(value); }
  NodeId apply(Op op, NodeId a, NodeId b) { return graph_.apply(op, {a, b}); }
  void forbid(NodeId condition) { conditions_.push_back(graph_.negation(condition)); }

 private:
  Graph graph_;
  AddressTable addresses_;
  std::vector<NodeId> ints_;
  std::vector<NodeId> conditions_;
};

/// Queens that do not attack each other. Each has its row, and chooses a column.
class Queens : public IntPuzzle {
 public:
  explicit Queens(std::size_t count) : IntPuzzle(count, static_cast<std::int64_t>(count) - 1) {
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        const auto rows = static_cast<std::int64_t>(b - a);
        for (const std::int64_t offset : {-rows, std::int64_t{0}, rows})
          forbid(apply(Op::kEqInt, int_at(a), apply(Op::kAdd, int_at(b), constant(offset))));
      }
    }
  }
};

/// Six ints from 0 to 3, and pairs of values that some of them do not have together.
class ForbiddenPairs : public IntPuzzle {
 public:
  explicit ForbiddenPairs(std::mt19937_64& random) : IntPuzzle(kInts, kLast) {
    for (std::size_t n = 30 + random() % 50; n > 0; --n) {
      const std::size_t b = 1 + random() % (kInts - 1), a = random() % b;
      const Pair pair{a, b, value(random), value(random)};
      forbid(apply(Op::kAnd, apply(Op::kEqInt, int_at(pair.a), constant(pair.of_a)),
                   apply(Op::kEqInt, int_at(pair.b), constant(pair.of_b))));
      pairs_.push_back(pair);
    }
  }

  static std::int64_t value(std::mt19937_64& random) {
    return static_cast<std::int64_t>(random() % (kLast + 1));
  }

  /// Returns all solutions, by trying all values.
  std::set<Values> solutions() const {
    std::set<Values> fitting;
    Values values(kInts);
    do {
      const auto breaks = [&](const Pair& pair) {
        return values[pair.a] == pair.of_a && values[pair.b] == pair.of_b;
      };
      if (std::ranges::none_of(pairs_, breaks)) fitting.insert(values);
    } while (increment(values));
    return fitting;
  }

 private:
  static constexpr std::size_t kInts = 6;
  static constexpr std::int64_t kLast = 3;
  struct Pair {
    std::size_t a, b;
    std::int64_t of_a, of_b;
  };

  /// Goes on to the next values. Returns false behind the last ones.
  static bool increment(Values& values) {
    for (std::int64_t& value : values) {
      if (value++ < kLast) return true;
      value = 0;
    }
    return false;
  }

  std::vector<Pair> pairs_;
};

double distance(const IntPuzzle::Values& a, const IntPuzzle::Values& b) {
  std::size_t others = 0;
  for (std::size_t row = 0; row < a.size(); ++row) others += a[row] == b[row] ? 0 : 1;
  return static_cast<double>(others) / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("enumerator: from whichever model it begins near, it gives that first and each other once") {
  const Queens queens(7);
  Enumerator from_lowest = queens.enumerator();
  const std::vector<IntPuzzle::Values> boards = queens.rest(from_lowest);
  const std::set<IntPuzzle::Values> all(boards.begin(), boards.end());
  CHECK(boards.size() == 40);
  REQUIRE(all.size() == 40);
  for (const IntPuzzle::Values& board : boards) {
    Enumerator enumerator = queens.enumerator();
    enumerator.begin_near([&](std::size_t row) { return board[row]; });
    const std::vector<IntPuzzle::Values> found = queens.rest(enumerator);
    CHECK(found.front() == board);
    CHECK(found.size() == 40);
    CHECK(std::set(found.begin(), found.end()) == all);
  }
}

TEST_CASE("enumerator: begins near values that are no model, after it has given up, too") {
  const StopSignal never;
  const Queens queens(9);
  Enumerator enumerator = queens.enumerator();
  CHECK(enumerator.next(never, 0) == Enumerator::Outcome::kTooHard);
  enumerator.begin_near([](std::size_t) { return 4; });
  const std::vector<IntPuzzle::Values> found = queens.rest(enumerator);
  CHECK(found.size() == 352);
  CHECK(std::set(found.begin(), found.end()).size() == 352);
  double sum = 0;
  for (std::size_t i = 1; i < found.size(); ++i) sum += distance(found[i - 1], found[i]);
  CHECK(sum / 351 < 0.8);  // of two out of all boards, the mean is 0.9
}

TEST_CASE("enumerator: what is required may be asked for again") {
  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> ints;
  for (const char* name : {"x", "y", "z"})
    ints.push_back(graph.choice({addresses.address(name), Distribution::range(1, 3)}));
  const auto equal = [&](std::size_t a, std::size_t b) {
    return graph.apply(Op::kEqInt, {ints[a], ints[b]});
  };
  NodeId differ = kTrue;
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
    differ = graph.conjunction(differ, graph.negation(equal(a, b)));
  const NodeId either = graph.disjunction(equal(0, 1), graph.apply(Op::kLtInt, {ints[0], ints[2]}));
  const auto models = [&](const std::vector<NodeId>& conditions) {
    Enumerator enumerator(graph, conditions, std::vector<std::size_t>{0, 1, 2});
    std::size_t number = 0;
    while (enumerator.next(StopSignal()) == Enumerator::Outcome::kFound) ++number;
    return number;
  };
  CHECK(models({differ}) == 6);
  CHECK(models({differ, differ}) == 6);
  CHECK(models({differ, either}) == 3);
  CHECK(models({either, differ}) == 3);
  CHECK(models({differ, graph.negation(differ)}) == 0);
  CHECK(models({graph.negation(differ), differ}) == 0);
}

TEST_CASE(
    "enumerator: gives all there is of generated puzzles, after however many dead ends it begins anew") {
  const StopSignal never;
  std::mt19937_64 random(1);
  int gave_up = 0, others = 0;
  for (int round = 0; round < 1000; ++round) {
    const ForbiddenPairs puzzle(random);
    Enumerator enumerator = puzzle.enumerator();
    if (random() % 2 == 0) {
      const auto outcome = enumerator.next(never, random() % 2);
      if (outcome != Enumerator::Outcome::kTooHard) continue;
      ++gave_up;
    }
    const std::set<IntPuzzle::Values> all = puzzle.solutions();
    if (all.empty()) continue;
    const IntPuzzle::Values first =
        *std::next(all.begin(), static_cast<std::ptrdiff_t>(random() % all.size()));
    enumerator.begin_near([&](std::size_t i) { return first[i]; });
    const std::vector<IntPuzzle::Values> found = puzzle.rest(enumerator);
    REQUIRE(found.size() == all.size());
    CHECK(found.front() == first);
    CHECK(std::set(found.begin(), found.end()) == all);
    if (all.size() > 1) ++others;
  }
  CHECK(gave_up > 20);
  CHECK(others > 200);
}

}  // namespace solitaire
