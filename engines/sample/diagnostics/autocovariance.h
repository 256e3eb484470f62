#pragma once
#include <span>
#include <vector>

namespace solitaire {

/// For each lag, from 0 to one less than there are values: the mean over the series of the products of
/// values, less their mean, that are so far apart. The sum is divided by the number of all values, not of
/// products. In time that hardly grows faster than the series: by the fast Fourier transform (Wiener,
/// Khinchin).
std::vector<double> autocovariances(std::span<const double> values);

}  // namespace solitaire
