#include "engines/count/xor_sampler.h"

#include <algorithm>

#include "engines/tuning.h"

namespace solitaire {
namespace {

/// Bounds the probability that the trial cells have at most tuning::kModelsInTrialCell models on the average,
/// though for the number of parities it should be kMostInCell, or twice as much with one parity less, and so
/// on: by Cantelli's inequality, as the variance of their number is at most its mean.
double mistrial(std::size_t cells) {
  double sum = 0;
  for (double mean = kMostInCell; mean < 1e12; mean *= 2) {
    const double excess = mean - static_cast<double>(tuning::kModelsInTrialCell);
    sum += mean / (mean + excess * excess * static_cast<double>(cells));
  }
  return sum;
}

/// Looks at random cells of a part.
class Trials {
 public:
  Trials(SpacePart& part, RandomStream& random, const StopSignal& stop)
      : part_(part), random_(random), stop_(stop) {}

  /// Returns true if that many cells of so many parities have few models on the average.
  bool small(std::size_t parities, std::size_t cells) {
    std::size_t left = cells * tuning::kModelsInTrialCell + 1;
    for (std::size_t i = 0; i < cells && left > 0; ++i)
      left -= part_.find(random_parities(random_, part_.bits(), parities), left, stop_).size();
    return left > 0;
  }

 private:
  SpacePart& part_;
  RandomStream& random_;
  const StopSignal& stop_;
};

}  // namespace

std::vector<XorConstraint> random_parities(RandomStream& random, std::size_t bits, std::size_t count) {
  std::vector<XorConstraint> parities(count);
  for (XorConstraint& parity : parities) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < bits; ++i, word >>= 1) {
      if (i % 64 == 0) word = random.next();
      parity.chosen.push_back((word & 1) != 0);
    }
    parity.odd = random.below(2) != 0;
  }
  return parities;
}

std::uint32_t parities_for_cells(SpacePart& part, double confidence, RandomStream& random,
                                 const StopSignal& stop) {
  Trials trials(part, random, stop);
  std::uint32_t low = 0;
  std::uint32_t high = 1;
  while (!trials.small(high, 1)) {
    low = high;
    high *= 2;
  }
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (trials.small(middle, 1) ? high : low) = middle;
  }
  // Each number is tried at most once, with cells of its own.
  std::size_t cells = 1;
  while (mistrial(cells) > 1 - confidence) ++cells;
  if (!trials.small(high, cells)) {
    while (!trials.small(++high, cells)) {
    }
    return high;
  }
  while (high > 0 && trials.small(high - 1, cells)) --high;
  return high;
}

CellSampler::CellSampler(SpacePart& part, RandomStream random, const StopSignal& stop)
    : part_(part), parities_(parities_for_cells(part, kConfidence, random, stop)) {}

BitModel CellSampler::draw(RandomStream& random, const StopSignal& stop) {
  while (true) {
    const std::uint64_t slot = random.below(kSlots);
    const std::vector<XorConstraint> parities = random_parities(random, part_.bits(), parities_);
    std::vector<BitModel> models = part_.find(parities, kSlots + 1, stop);
    if (models.size() <= kSlots && slot < models.size()) return std::move(models[slot]);
  }
}

}  // namespace solitaire
