// Going through all models, from the lowest values of the choices on and from a model that is known, whether
// or not clauses are learned on the way.
#include "smt/cdcl/enumerator.h"

#include <doctest/doctest.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace solitaire {
namespace {

/// Queens that do not attack each other. Each has its row, and chooses a column.
class Queens {
 public:
  explicit Queens(std::size_t count) : count_(count) {
    const auto last = static_cast<std::int64_t>(count) - 1;
    std::vector<NodeId> columns;
    for (std::size_t row = 0; row < count; ++row)
      columns.push_back(
          graph_.choice({addresses_.address("q" + std::to_string(row)), Distribution::range(0, last)}));
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = a + 1; b < count; ++b) {
        const auto rows = static_cast<std::int64_t>(b - a);
        for (const std::int64_t offset : {-rows, std::int64_t{0}, rows})
          differ(columns[a], graph_.apply(Op::kAdd, {columns[b], graph_.constant(offset)}));
      }
    }
  }

  Enumerator enumerator() const {
    std::vector<std::size_t> variables;
    for (std::size_t row = 0; row < count_; ++row) variables.push_back(row);
    return {graph_, conditions_, variables};
  }

  using Board = std::vector<std::int64_t>;

  /// Returns the boards that are left, in the order in which they come.
  std::vector<Board> rest(Enumerator& enumerator) const {
    const StopSignal never;
    std::vector<Board> boards;
    while (enumerator.next(never) == Enumerator::Outcome::kFound) {
      Board& board = boards.emplace_back();
      for (std::size_t row = 0; row < count_; ++row) board.push_back(enumerator.value(row));
    }
    CHECK(enumerator.next(never) == Enumerator::Outcome::kNone);
    return boards;
  }

 private:
  void differ(NodeId a, NodeId b) {
    conditions_.push_back(graph_.negation(graph_.apply(Op::kEqInt, {a, b})));
  }

  std::size_t count_;
  Graph graph_;
  AddressTable addresses_;
  std::vector<NodeId> conditions_;
};

double distance(const Queens::Board& a, const Queens::Board& b) {
  std::size_t others = 0;
  for (std::size_t row = 0; row < a.size(); ++row) others += a[row] == b[row] ? 0 : 1;
  return static_cast<double>(others) / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("enumerator: from whichever model it begins near, it gives that first and each other once") {
  const Queens queens(7);
  Enumerator from_lowest = queens.enumerator();
  const std::vector<Queens::Board> boards = queens.rest(from_lowest);
  const std::set<Queens::Board> all(boards.begin(), boards.end());
  CHECK(boards.size() == 40);
  REQUIRE(all.size() == 40);
  for (const Queens::Board& board : boards) {
    Enumerator enumerator = queens.enumerator();
    enumerator.begin_near([&](std::size_t row) { return board[row]; });
    const std::vector<Queens::Board> found = queens.rest(enumerator);
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
  const std::vector<Queens::Board> found = queens.rest(enumerator);
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

}  // namespace solitaire
