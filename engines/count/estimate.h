#pragma once
#include <functional>

#include "engines/count/xor_sampler.h"

namespace solitaire {

/// The guarantee of an estimated number. Over seeds, with a probability of at least `confidence`, the
/// estimate is neither more than 1 + tolerance times the true number, nor less than that divided by 1 +
/// tolerance.
struct Accuracy {
  double tolerance = 0.8;   // more than 0
  double confidence = 0.9;  // between 0 and 1
};

/// A number of models, by its logarithm.
struct Estimate {
  double log10 = 0;
};

/// Estimates how many models a part has, more than a few: counts random cells, as ApproxMC does (Chakraborty,
/// Meel and Vardi, "A Scalable Approximate Model Counter", 2013, and "Algorithmic Improvements in Approximate
/// Counting for Probabilistic Inference", 2016).
///
/// Unlike there, the number of parities is settled first, and then cells of that many are counted until they
/// have enough models in all. The mean and variance of such a sum are known, so that Cantelli's inequality
/// bounds its error, with far fewer cells than a median of counts needs. `progress`, if any, is told which
/// part of the second step is done. Throws Interrupted.
Estimate estimate_models(SpacePart& part, const Accuracy& accuracy, RandomStream random,
                         const StopSignal& stop, const std::function<void(double)>& progress = nullptr);

/// Estimates how many solutions there are from how many attempts of the sampler fail until some succeed: each
/// attempt waits for a time that is exponentially distributed, and the sum of these times has a known
/// distribution but for the probability of success (Huber, "A Bernoulli mean estimate with known relative
/// error distribution", 2017). `progress` and what is thrown are as above.
Estimate estimate_solutions(NestedSampler& sampler, const Accuracy& accuracy, RandomStream random,
                            const StopSignal& stop, const std::function<void(double)>& progress = nullptr);

}  // namespace solitaire
