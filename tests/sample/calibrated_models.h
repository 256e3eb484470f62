#pragma once
#include "tests/sample/calibration.h"

namespace solitaire {

/// One for each way in which choices are changed.
inline constexpr CalibratedModel kCalibratedModels[] = {
    {"s = gamma(3, 2); theta = normal(1, 2);", "normal(theta, precision: s)", "Normal(theta, precision: s)",
     3},
    {"m = normal(0, 1); theta = exponential(1);", "normal(m, theta)", "Normal(m, theta)", 4},
    {"theta = beta(2, 1.5);", "cond(flip(0.1 + 0.8 * theta), 1, 0)",
     "Categorical([0.9 - 0.8 * theta, 0.1 + 0.8 * theta])", 5},
    {"theta = range(1, 3); c = [normal(i, 1) for i in 1..theta];", "normal(sum(c), 1)", "Normal(sum(c), 1)",
     2},
    {"w = dirichlet([1, 2, 1]); theta = w[1];", "categorical(w)", "Categorical(w)", 4},
    {"u = uniform(0, 2); theta = poisson(1 + u);", "normal(theta * u, 1)", "Normal(theta * u, 1)", 2},
    // Long enough for the No-U-Turn sampler to know how the floats lie.
    {"u = uniform(0, 3); m = normal(0, 1); theta = exponential(1 + u);", "normal(m + u, theta)",
     "Normal(m + u, theta)", 4, 200},
};

}  // namespace solitaire
