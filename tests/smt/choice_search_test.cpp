// The choice to decide next against its definition: of the choices with open inputs the first with the
// fewest.
#include "smt/cdcl/choice_search.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <vector>

#include "tests/smt/random_clauses.h"

namespace solitaire {
namespace {

std::optional<std::size_t> first_with_fewest(const ChoiceSearch& search, std::size_t choices,
                                             const Propagator& propagator) {
  std::optional<std::size_t> best;
  std::ptrdiff_t fewest = 0;
  for (std::size_t i = 0; i < choices; ++i) {
    const auto open =
        std::ranges::count_if(search.inputs(i), [&](int input) { return propagator.is_open(input); });
    if (open == 0 || (best && open >= fewest)) continue;
    fewest = open;
    best = i;
  }
  return best;
}

std::vector<int> open_variables(const Propagator& propagator) {
  std::vector<int> open;
  for (std::size_t i = 1; i < propagator.variables(); ++i) {
    if (propagator.is_open(static_cast<int>(i))) open.push_back(static_cast<int>(i));
  }
  return open;
}

/// Adds choices of 1 to 6 inputs, and clauses over these and variables of no choice.
struct RandomSearch {
  explicit RandomSearch(std::uint64_t seed) : random(seed) {}

  void add_choice() {
    std::vector<Literal> inputs(1 + random() % 6);
    for (Literal& input : inputs) input = circuit.input();
    search.add(inputs, cnf);
    ++choices;
  }
  void add_clauses(int number) {
    const auto variables = static_cast<int>(propagator.variables()) + 3;
    for (int i = 0; i < number; ++i) propagator.clause(random_clause(random, variables, 2, 3));
  }
  void check_next() { REQUIRE(search.next() == first_with_fewest(search, choices, propagator)); }

  std::mt19937_64 random;
  Circuit circuit;
  Propagator propagator;
  Cnf cnf{circuit, propagator};
  ChoiceSearch search{propagator};
  std::size_t choices = 0;
};

}  // namespace

TEST_CASE("choice search: the next choice is the first with the fewest open inputs, whatever came before") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    RandomSearch random(seed);
    for (std::uint64_t i = 0; i < 1 + seed % 20; ++i) random.add_choice();
    random.add_clauses(20);
    for (int step = 0; step < 120; ++step) {
      if (!random.propagator.propagate()) {
        if (random.propagator.decisions() == 0) break;
        random.propagator.undo();
        continue;
      }
      if (step % 3 != 0) random.check_next();  // some changes are met together
      const std::vector<int> open = open_variables(random.propagator);
      if (open.empty() || random.random() % 3 == 0) {
        if (random.propagator.decisions() == 0) break;
        random.propagator.undo();
      } else {
        decide_randomly(random.propagator, open, random.random);
      }
      if (step % 40 == 39) {  // further choices come between two searches
        while (random.propagator.decisions() > 0) random.propagator.undo();
        random.add_choice();
      }
    }
    random.check_next();
  }
}

TEST_CASE("choice search: a tournament knows the first of the least numbers") {
  std::mt19937_64 random(7);
  Tournament tournament;
  CHECK(tournament.least() == Tournament::kOut);
  std::vector<std::size_t> numbers;
  for (int step = 0; step < 4000; ++step) {
    if (numbers.empty() || random() % 20 == 0) numbers.push_back(Tournament::kOut);
    const std::size_t place = random() % numbers.size();
    numbers[place] = random() % 4 == 0 ? Tournament::kOut : random() % 9;
    tournament.set(place, numbers[place]);
    const auto least = std::ranges::min_element(numbers);
    REQUIRE(tournament.least() == *least);
    if (*least != Tournament::kOut)
      REQUIRE(tournament.first() == static_cast<std::size_t>(least - numbers.begin()));
  }
}

}  // namespace solitaire
