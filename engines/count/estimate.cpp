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

}  // namespace

double Estimate::log10() const { return std::log10(models / cells) + parities * std::log10(2.0); }

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
  return {static_cast<double>(wanted), static_cast<double>(cells), parities};
}

}  // namespace solitaire
