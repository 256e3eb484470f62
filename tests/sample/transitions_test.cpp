// Single steps of chains on three executions: each transition comes as often as the rule of Metropolis and
// Hastings says. Frequencies alone would not show, say, that a chain hardly moves.
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>

#include "engines/sample/lightweight.h"
#include "engines/sample/shred/shred.h"
#include "tests/sample/enumeration.h"

namespace solitaire {
namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) product[i][j] += a[i][k] * b[k][j];
  return product;
}

/// A step that proposes by `way[i][j]` and accepts by min(1, ratio(i, j)).
Matrix accepted(const Matrix& way, const std::function<double(std::size_t, std::size_t)>& ratio) {
  Matrix step{};
  for (std::size_t i = 0; i < 3; ++i) {
    step[i][i] = 1;
    for (std::size_t j = 0; j < 3; ++j) {
      if (i == j) continue;
      step[i][j] = way[i][j] * std::min(1.0, ratio(i, j));
      step[i][i] -= step[i][j];
    }
  }
  return step;
}

/// Draws an execution from the priors; `factors` are what is observed.
Matrix restart(const Row& priors, const Row& factors) {
  return accepted({priors, priors, priors},
                  [&](std::size_t i, std::size_t j) { return factors[j] / factors[i]; });
}

/// Counts what follows each execution in a sweep, and compares by chi-squared. The program returns 0, 1 or 2.
template <class AnyChain>
void check_transitions(const char* text, const Matrix& expected) {
  INFO(text);
  const Program program = sampled_program(text);
  const ParamValues params;
  AnyChain chain(program, params, {}, 17, 0);
  const ReturnedNumbers returned(program);
  const auto state = [&] {
    std::vector<std::string> names;
    std::vector<double> numbers;
    chain.read(returned, names, numbers);
    return static_cast<std::size_t>(numbers.at(0));
  };
  for (int i = 0; i < 300; ++i) chain.sweep();
  chain.end_warmup();
  std::array<std::array<double, 3>, 3> counts{};
  std::size_t from = state();
  for (int i = 0; i < 30'000; ++i) {
    chain.sweep();
    const std::size_t to = state();
    ++counts[from][to];
    from = to;
  }
  double chi_squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double all = counts[i][0] + counts[i][1] + counts[i][2];
    REQUIRE(all > 300);
    for (std::size_t j = 0; j < 3; ++j) {
      const double mean = all * expected[i][j];
      if (expected[i][j] < 1e-12) {
        CHECK(counts[i][j] == 0);
      } else {
        chi_squared += (counts[i][j] - mean) * (counts[i][j] - mean) / mean;
      }
    }
  }
  CHECK(chi_squared < 27.9);  // with 6 degrees of freedom, one time in 10,000
}

constexpr const char* kOneChoice =
    "a = choose([0, 1, 2], weights: [5, 3, 2]); factor(log([1, 2, 4][a])); return a;";
constexpr Row kPriors = {0.5, 0.3, 0.2};
constexpr Row kFactors = {1, 2, 4};
constexpr double kSum = 0.5 + 0.6 + 0.8;
constexpr Row kPosterior = {0.5 / kSum, 0.6 / kSum, 0.8 / kSum};

TEST_CASE("transitions: of one choice with three values") {
  constexpr double kHalf = 0.5;
  const Matrix other = {Row{0, kHalf, kHalf}, Row{kHalf, 0, kHalf}, Row{kHalf, kHalf, 0}};
  const Matrix step =
      accepted(other, [](std::size_t i, std::size_t j) { return kPosterior[j] / kPosterior[i]; });
  const Matrix gibbs = {kPosterior, kPosterior, kPosterior};
  check_transitions<LightweightChain>(kOneChoice, times(step, restart(kPriors, kFactors)));
  check_transitions<ShredChain>(kOneChoice, times(gibbs, restart(kPriors, kFactors)));
}

// Executions 0 with one choice, and 1 and 2 with two.
constexpr const char* kBirth =
    "a = flip(0.4); x = if a then cond(flip(0.3), 2, 1) else 0; factor(log([1, 3, 2][x])); return x;";

constexpr Matrix kStill = {Row{1, 0, 0}, Row{0, 1, 0}, Row{0, 0, 1}};

/// Either choice is picked. `both` is how the second one changes, where it is there.
Matrix birth_step(const Matrix& both, const Row& density) {
  // The first choice: a birth draws the second choice from its prior, a death forgets it. One choice to pick
  // from becomes two, and the other way round.
  const Matrix way = {Row{0, 0.7, 0.3}, Row{1, 0, 0}, Row{1, 0, 0}};
  const Row drawn = {1, 0.7, 0.3};
  const Row picks = {1, 2, 2};
  const Matrix first = accepted(way, [&](std::size_t i, std::size_t j) {
    return density[j] / density[i] * drawn[i] / drawn[j] * picks[i] / picks[j];
  });
  Matrix step = first;
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) step[i][j] = 0.5 * first[i][j] + 0.5 * both[i][j];
  return step;
}

TEST_CASE("transitions: of a choice that comes and goes") {
  const Row priors = {0.6, 0.4 * 0.7, 0.4 * 0.3}, factors = {1, 3, 2};
  const Row density = {0.6, 0.4 * 0.7 * 3, 0.4 * 0.3 * 2};
  const Matrix other = {Row{1, 0, 0}, Row{0, 0, 1}, Row{0, 1, 0}};
  const Matrix changed =
      accepted(other, [&](std::size_t i, std::size_t j) { return density[j] / density[i]; });
  const double both = density[1] + density[2];
  const Row given = {0, density[1] / both, density[2] / both};
  const Matrix gibbs = {Row{1, 0, 0}, given, given};
  const Matrix anew = restart(priors, factors);
  const Matrix step = birth_step(changed, density);
  check_transitions<LightweightChain>(kBirth, times(times(step, step), anew));
  // On traces the second choice has its turn first, and none when it is picked.
  const Matrix first = birth_step(kStill, density);
  check_transitions<ShredChain>(kBirth, times(times(gibbs, times(first, first)), anew));
}

}  // namespace
}  // namespace solitaire
