#include "engines/count/estimate.h"

#include <cmath>

namespace solitaire {
namespace {

/// Cantelli's bound for a sum that lies so far from its mean, where its variance is at most the mean.
double beyond(double mean, double distance) { return mean / (mean + distance * distance); }

/// The probability that an estimate from cells with so many models in all is off, while those of a cell are
/// kMostInCell on the average, or fewer.
///
/// An estimate that is too high means that the models were there too soon, after cells that should have at
/// most `soon`; too low, that they were not there after cells that should have at least `late`.
double misestimate(double models, double tolerance) {
  const double soon = models / (1 + tolerance);
  const double late = models * (1 + tolerance) - kMostInCell;
  return late <= models ? 1 : beyond(soon, models - soon) + beyond(late, late - models);
}

/// The probability that a Poisson process has so many events before a time at which `mean` are expected.
double reached(std::size_t events, double mean) {
  double fewer = 0;
  double log_term = -mean;  // the terms themselves may be too small for a float
  for (std::size_t i = 0; i < events; ++i) {
    fewer += std::exp(log_term);
    log_term += std::log(mean / static_cast<double>(i + 1));
  }
  return 1 - fewer;
}

/// The probability that an estimate from so many successes is off: it is successes - 1 over the time that
/// they take, of which the product with the true probability is distributed as that of a process of rate 1.
double misjudgement(std::size_t successes, double tolerance) {
  const double expected = static_cast<double>(successes - 1);
  return 1 - reached(successes, expected * (1 + tolerance)) + reached(successes, expected / (1 + tolerance));
}

/// Returns how many successes are enough for an estimate.
std::size_t enough_successes(const Accuracy& accuracy) {
  const auto are_enough = [&](std::size_t successes) {
    return misjudgement(successes, accuracy.tolerance) <= 1 - accuracy.confidence;
  };
  std::size_t enough = 2;
  while (!are_enough(enough)) enough *= 2;
  std::size_t low = enough / 2;  // too few
  while (enough - low > 1) {
    const std::size_t middle = low + (enough - low) / 2;
    (are_enough(middle) ? enough : low) = middle;
  }
  return enough;
}

}  // namespace

Estimate estimate_models(SpacePart& part, const Accuracy& accuracy, RandomStream random,
                         const StopSignal& stop, const std::function<void(double)>& progress) {
  const double risk = (1 - accuracy.confidence) / 2;  // of each of the two steps
  std::size_t wanted = 1;
  while (misestimate(static_cast<double>(wanted), accuracy.tolerance) > risk) ++wanted;
  const std::uint32_t parities = parities_for_cells(part, 1 - risk, random, stop);
  std::size_t models = 0;
  std::size_t cells = 0;
  for (; models < wanted; ++cells) {
    if (progress) progress(static_cast<double>(models) / static_cast<double>(wanted));
    models += part.find(random_parities(random, part.bits(), parities), wanted - models, stop).size();
  }
  return {std::log10(static_cast<double>(wanted) / static_cast<double>(cells)) + parities * std::log10(2.0)};
}

Estimate estimate_solutions(NestedSampler& sampler, const Accuracy& accuracy, RandomStream random,
                            const StopSignal& stop, const std::function<void(double)>& progress) {
  const std::size_t wanted = enough_successes(accuracy);
  double time = 0;
  for (std::size_t successes = 0; successes < wanted;) {
    if (progress) progress(static_cast<double>(successes) / static_cast<double>(wanted));
    time -= std::log(random.uniform());
    if (sampler.succeeds(random, stop)) ++successes;
  }
  return {std::log10(sampler.bound() * static_cast<double>(wanted - 1) / time)};
}

}  // namespace solitaire
