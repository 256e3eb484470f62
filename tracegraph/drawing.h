#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/random.h"

namespace solitaire {

// Numbers drawn from named distributions. Each depends on nothing but the stream, on any machine, which the
// distributions of <random> do not promise.

/// A standard normal number.
double draw_normal(RandomStream& stream);
/// shape > 0, rate > 0. The result is a positive finite float, also where the exact number is none.
double draw_gamma(double shape, double rate, RandomStream& stream);
/// a > 0, b > 0. The result lies strictly between 0 and 1.
double draw_beta(double a, double b, RandomStream& stream);
/// mean > 0; at most 2^62.
std::int64_t draw_poisson(double mean, RandomStream& stream);
/// How many failures come before a success of that probability, 0 < probability <= 1; at most 2^62.
std::int64_t draw_geometric(double probability, RandomStream& stream);
/// A position, as probable as its weight is large. `sum` is the weights' sum, above 0. A weight of 0 is never
/// drawn.
std::size_t draw_index(std::span<const double> weights, double sum, RandomStream& stream);

}  // namespace solitaire
