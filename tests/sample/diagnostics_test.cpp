// Diagnostics of draws against series whose autocorrelation is known.
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

#include "engines/sample/diagnostics/autocovariance.h"
#include "engines/sample/diagnostics/draw_summary.h"
#include "engines/sample/diagnostics/normal_quantile.h"
#include "tracegraph/drawing.h"

namespace solitaire {
namespace {

/// Chains in which each draw is so much of the one before, and the rest new; with variance 1.
ChainDraws correlated(double correlation, std::size_t length, std::size_t chains = 4) {
  ChainDraws draws;
  for (std::size_t c = 0; c < chains; ++c) {
    RandomStream stream(3, Purpose::kSample, c);
    std::vector<double> chain{draw_normal(stream)};
    while (chain.size() < length)
      chain.push_back(correlation * chain.back() +
                      std::sqrt(1 - correlation * correlation) * draw_normal(stream));
    draws.push_back(std::move(chain));
  }
  return draws;
}

TEST_CASE("the effective size of an autoregression is the known share of its length") {
  for (const double correlation : {0.0, 0.5, 0.9}) {
    const ChainDraws draws = correlated(correlation, 20'000);
    const double expected = 80'000 * (1 - correlation) / (1 + correlation);
    CHECK(effective_size(draws) == doctest::Approx(expected).epsilon(0.1));
    const DrawSummary summary = summarize(draws);
    CHECK(summary.ess_bulk == doctest::Approx(expected).epsilon(0.1));
    CHECK(summary.mcse == doctest::Approx(summary.sd / std::sqrt(expected)).epsilon(0.1));
    CHECK(summary.rhat < 1.01);
  }
}

TEST_CASE("autocovariances by the transform are those of the definition") {
  const std::vector<double> values = correlated(0.7, 37, 1)[0];
  double mean = 0;
  for (const double value : values) mean += value / 37;
  const std::vector<double> found = autocovariances(values);
  REQUIRE(found.size() == 37);
  for (std::size_t lag = 0; lag < 37; ++lag) {
    double sum = 0;
    for (std::size_t i = lag; i < 37; ++i) sum += (values[i] - mean) * (values[i - lag] - mean);
    CHECK(std::abs(found[lag] - sum / 37) < 1e-12);
  }
}

TEST_CASE("draws that alternate are worth more than as many independent ones") {
  CHECK(effective_size(correlated(-0.5, 20'000)) > 150'000);
}

TEST_CASE("moments and quantiles of normal draws are those of the distribution") {
  const DrawSummary summary = summarize(correlated(0, 20'000));
  CHECK(std::abs(summary.mean) < 0.02);
  CHECK(summary.sd == doctest::Approx(1).epsilon(0.02));
  CHECK(summary.q5 == doctest::Approx(-1.6449).epsilon(0.02));
  CHECK(std::abs(summary.q50) < 0.02);
  CHECK(summary.q95 == doctest::Approx(1.6449).epsilon(0.02));
  CHECK(quantile(std::vector<double>{1, 2, 4}, 0.5) == 2);
  CHECK(quantile(std::vector<double>{1, 2, 4}, 0.75) == 3);
}

TEST_CASE("R-hat sees a chain apart, a chain that is wider, and one that drifts") {
  const ChainDraws draws = correlated(0, 1000);
  CHECK(summarize(draws).rhat < 1.01);
  ChainDraws apart = draws;
  for (double& x : apart[1]) x += 1;
  CHECK(summarize(apart).rhat > 1.05);
  ChainDraws wider = draws;
  for (double& x : wider[2]) x *= 3;
  CHECK(summarize(wider).rhat > 1.05);
  ChainDraws drifting = draws;
  for (auto& chain : drifting)
    for (std::size_t i = 0; i < chain.size(); ++i) chain[i] += static_cast<double>(i) / 500;
  CHECK(summarize(drifting).rhat > 1.05);
}

TEST_CASE("draws that are all alike tell no more than their value") {
  const DrawSummary summary = summarize({{2, 2, 2, 2, 2, 2, 2, 2}, {2, 2, 2, 2, 2, 2, 2, 2}});
  CHECK(summary.mean == 2);
  CHECK(summary.mcse == 0);
  CHECK(std::isnan(summary.rhat));
}

TEST_CASE("normal quantiles undo the distribution function") {
  for (const double x : {-6.0, -2.5, -0.3, 0.0, 0.7, 3.0, 5.0})
    CHECK(normal_quantile(0.5 * std::erfc(-x / std::sqrt(2.0))) == doctest::Approx(x).epsilon(1e-9));
}

/// x' = 0.9 x + e, of which 1 in 19 draws counts.
ChainDraws autoregressive(std::size_t length) {
  RandomStream stream(3, Purpose::kSample, 9);
  ChainDraws chains(2);
  for (auto& chain : chains) {
    double x = 0;
    for (std::size_t i = 0; i < length; ++i)
      chain.push_back(x = 0.9 * x + std::sqrt(0.19) * draw_normal(stream));
  }
  return chains;
}

TEST_CASE(
    "diagnostics: long chains, of which means of blocks are looked at, have the effective size that theory "
    "gives") {
  const DrawSummary found = summarize(autoregressive(200'000));
  CHECK(found.ess_bulk == doctest::Approx(400'000 / 19.0).epsilon(0.1));
  CHECK(found.mcse == doctest::Approx(1 / std::sqrt(400'000 / 19.0)).epsilon(0.1));
  CHECK(found.ess_tail > found.ess_bulk);
  CHECK(found.rhat == doctest::Approx(1).epsilon(0.002));
  CHECK(found.sd == doctest::Approx(1).epsilon(0.02));
  CHECK(found.q5 == doctest::Approx(-1.645).epsilon(0.03));
}

}  // namespace
}  // namespace solitaire
