// Distributions against closed forms: what is drawn stands in the proportions that the densities say.
#include "tracegraph/distribution.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <limits>
#include <map>
#include <vector>

namespace solitaire {
namespace {

constexpr int kDraws = 20'000;

std::vector<TypedScalar> draws(const Distribution& distribution) {
  RandomStream stream(7, Purpose::kSample, 0);
  std::vector<TypedScalar> values;
  for (int i = 0; i < kDraws; ++i) values.push_back(distribution.sample(stream));
  return values;
}

/// Pearson's statistic of the counts against equal or given probabilities.
double chi_square(const std::map<TypedScalar, int, std::less<>>& counts, const Distribution& distribution) {
  double sum = 0;
  for (std::uint64_t i = 0; i < distribution.size(); ++i) {
    const TypedScalar value = distribution.typed(distribution.value(i));
    const double expected = kDraws * std::exp(distribution.log_density(value));
    const auto found = counts.find(value);
    const double count = found == counts.end() ? 0 : found->second;
    if (expected > 0) sum += (count - expected) * (count - expected) / expected;
  }
  return sum;
}

TEST_CASE("distributions: finite ones are drawn as often as their densities say") {
  // With 9 degrees of freedom at most, one run in a million exceeds 45; the streams are fixed.
  for (const Distribution& distribution :
       {Distribution::range(-2, 7), Distribution::range(0, 10, 3), Distribution::index(4),
        Distribution::flip(), Distribution::flip(0.9), Distribution::flip(0), Distribution::flip(1)}) {
    std::map<TypedScalar, int, std::less<>> counts;
    for (const TypedScalar value : draws(distribution)) {
      REQUIRE(distribution.contains(value));
      ++counts[value];
    }
    CHECK(chi_square(counts, distribution) < 45);
    // The statistic tells the wrong probability: a coin of 0.5 is not one of 0.55.
    if (distribution == Distribution::flip()) CHECK(chi_square(counts, Distribution::flip(0.55)) > 45);
  }
}

TEST_CASE("distributions: the probabilities of a finite one sum to 1") {
  for (const Distribution& distribution :
       {Distribution::range(3, 3), Distribution::range(-5, 20, 4), Distribution::flip(0.3)}) {
    double sum = 0;
    for (std::uint64_t i = 0; i < distribution.size(); ++i)
      sum += std::exp(distribution.log_density(distribution.typed(distribution.value(i))));
    CHECK(sum == doctest::Approx(1));
  }
}

/// The largest distance between the empirical distribution function and the given one (Kolmogorov, Smirnov).
double largest_distance(std::vector<TypedScalar> values, const std::function<double(double)>& cumulative) {
  std::vector<double> sorted;
  for (const TypedScalar value : values) sorted.push_back(value.as_float());
  std::sort(sorted.begin(), sorted.end());
  double distance = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double wanted = cumulative(sorted[i]);
    distance = std::max({distance, std::abs(wanted - static_cast<double>(i) / kDraws),
                         std::abs(wanted - static_cast<double>(i + 1) / kDraws)});
  }
  return distance;
}

TEST_CASE("distributions: floats are drawn by their distribution functions, and densities are their slopes") {
  const auto normal = [](double mean, double deviation) {
    return [=](double x) { return 0.5 * std::erfc((mean - x) / (deviation * std::sqrt(2))); };
  };
  const auto uniform = [](double x) { return (x + 1) / 4; };
  const std::pair<Distribution, std::function<double(double)>> all[] = {
      {Distribution::normal(2, 0.5), normal(2, 0.5)}, {Distribution::uniform(-1, 3), uniform}};
  const double limit = 1.95 / std::sqrt(kDraws);  // exceeded by one run in a thousand; the streams are fixed
  for (const auto& [distribution, cumulative] : all) {
    CHECK(largest_distance(draws(distribution), cumulative) < limit);
    for (const double x : {0.5, 1.5, 2.25}) {
      const double slope = (cumulative(x + 1e-5) - cumulative(x - 1e-5)) / 2e-5;
      CHECK(std::exp(distribution.log_density(TypedScalar::of(x))) == doctest::Approx(slope).epsilon(1e-6));
    }
  }
  CHECK(largest_distance(draws(Distribution::normal(2, 0.55)), normal(2, 0.5)) > limit);
}

TEST_CASE("distributions: what cannot occur has no density, and another type is another value") {
  const double impossible = -std::numeric_limits<double>::infinity();
  CHECK(Distribution::range(0, 10, 2).log_density(TypedScalar::of(std::int64_t{3})) == impossible);
  CHECK(Distribution::range(0, 1).log_density(TypedScalar::of(true)) == impossible);
  CHECK(Distribution::flip().log_density(TypedScalar::of(std::int64_t{1})) == impossible);
  CHECK(Distribution::flip(1).log_density(TypedScalar::of(false)) == impossible);
  CHECK(Distribution::uniform(0, 1).log_density(TypedScalar::of(1.5)) == impossible);
  CHECK(TypedScalar::of(true) != TypedScalar::of(std::int64_t{1}));
  CHECK(to_text(TypedScalar::of(2.0)) == "2.0");
  CHECK(to_text(TypedScalar::of(false)) == "false");
  CHECK(to_text(TypedScalar::of(std::int64_t{-7})) == "-7");
}

}  // namespace
}  // namespace solitaire
