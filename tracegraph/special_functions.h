#pragma once

namespace solitaire {

/// The natural logarithm of |Gamma(x)|: infinite where Gamma has a pole, at 0 and the negative ints. Unlike
/// std::lgamma it keeps no state, so that threads can call it side by side.
double log_gamma(double x);

/// The derivative of log_gamma; NaN at its poles.
double digamma(double x);

}  // namespace solitaire
