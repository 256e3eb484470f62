// Problems whose numbers of solutions are known, by the solver with a proof that there is no other, and where
// their executions can be counted by running each.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <set>

#include "tests/support/program_run.h"

namespace solitaire {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

std::vector<Found> solve_all(const std::string& name, const Settings& settings = {}, Way way = Way::kDemand) {
  Program program = load("programs/" + name);
  const ParamValues params = read_params(program, settings, program.sources);
  return all_solutions(program, params, way);
}

/// How many solutions there are, by every engine that can count them.
std::size_t count(const std::string& name, const Settings& settings = {}, bool exhaustively = true) {
  const std::vector<Found> found = solve_all(name, settings);
  if (exhaustively) CHECK(found == solve_all(name, settings, Way::kExhaustive));
  return found.size();
}

TEST_CASE("counts: the example of section 4.2.2 has 8 solutions, where either call meets an even number") {
  const std::vector<Found> found = solve_all("example.sol");
  std::set<std::pair<std::string, std::string>> pairs;
  for (const Found& each : found) {
    REQUIRE(each.choices.size() == 2);
    pairs.emplace(each.choices[0], each.choices[1]);
  }
  std::set<std::pair<std::string, std::string>> wanted;
  for (int a = 0; a <= 4; ++a) {
    for (int b = 0; b <= 1; ++b) {
      if (a % 2 == 0 || b == 0)
        wanted.emplace("range = " + std::to_string(a), "range#2 = " + std::to_string(b));
    }
  }
  CHECK(wanted.size() == 8);
  CHECK(pairs == wanted);
  CHECK(found == solve_all("example.sol", {}, Way::kExhaustive));
}

TEST_CASE("counts: n queens") {
  CHECK(count("queens.sol", {{"n", "4"}}) == 2);
  CHECK(count("queens.sol", {{"n", "5"}}) == 10);
  CHECK(count("queens.sol", {{"n", "6"}}) == 4);
  CHECK(count("queens.sol", {{"n", "7"}}, false) == 40);
  CHECK(count("queens.sol", {{"n", "8"}}, false) == 92);
}

TEST_CASE("counts: magic squares of order 3") { CHECK(count("magic_square.sol", {}, false) == 8); }

TEST_CASE("counts: domino tilings") {
  CHECK(count("dominoes.sol", {{"width", "2"}, {"height", "2"}}) == 2);
  CHECK(count("dominoes.sol", {{"width", "3"}, {"height", "3"}}) == 0);
  CHECK(count("dominoes.sol", {{"width", "4"}, {"height", "3"}}) == 11);
  CHECK(count("dominoes.sol") == 36);
}

TEST_CASE("counts: self-avoiding walks") {
  CHECK(count("walks.sol", {{"steps", "1"}}) == 4);
  CHECK(count("walks.sol", {{"steps", "3"}}) == 36);
  CHECK(count("walks.sol") == 284);
}

TEST_CASE("counts: SEND + MORE = MONEY has one solution (slow)") {
  const std::vector<Found> found = solve_all("send_more_money.sol");
  REQUIRE(found.size() == 1);
  CHECK(found[0].value == "[9567, 1085]");
}

TEST_CASE("counts: subsets of 1 to n") {
  for (int n = 0; n <= 8; ++n) CHECK(count("subset.sol", {{"n", std::to_string(n)}}) == std::size_t{1} << n);
}

/// How many solutions a solver finds that starts each search from random values, and proves that there are no
/// others.
std::size_t found_one_by_one(const std::string& text) {
  const Program program = program_of(text);
  TracingEngine engine(program, {}, {});
  std::size_t found = 0;
  while (engine.next()) ++found;
  CHECK(engine.ending() == Ending::kExhausted);
  return found;
}

TEST_CASE(
    "counts: exactly one, at most one or all but one of some conditions, in groups where they are many") {
  for (const std::size_t n : {4, 5, 6, 7, 8, 9, 13, 17, 22}) {
    const std::string flips =
        fmt::format("xs = [flip() for i in 1..{}]; number = sum([cond(x, 1, 0) for x in xs]);\n", n);
    CAPTURE(flips);
    CHECK(found_one_by_one(flips + "assert(number == 1); return xs;") == n);
    CHECK(found_one_by_one(flips + "assert(number <= 1); return xs;") == n + 1);
    CHECK(found_one_by_one(flips + fmt::format("assert(number >= {}); return xs;", n - 1)) == n + 1);
  }
}

}  // namespace
}  // namespace solitaire
