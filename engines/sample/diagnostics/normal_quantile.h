#pragma once

namespace solitaire {

/// The standard normal number below which a share of all lies; 0 < share < 1.
double normal_quantile(double share);

}  // namespace solitaire
