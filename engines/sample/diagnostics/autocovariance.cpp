#include "engines/sample/diagnostics/autocovariance.h"

#include <bit>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>

namespace solitaire {
namespace {

using Complex = std::complex<double>;

/// Replaces a series, whose length is a power of two, by its Fourier transform (Cooley and Tukey 1965), or,
/// with direction 1 in place of -1, by its inverse times the length.
void transform_series(std::vector<Complex>& series, int direction) {
  const std::size_t size = series.size();
  for (std::size_t i = 1, j = 0; i < size;
       ++i) {  // each to the place that its number has with its bits reversed
    std::size_t bit = size >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(series[i], series[j]);
  }
  for (std::size_t length = 2; length <= size; length *= 2) {
    const double angle = direction * 2 * std::numbers::pi / static_cast<double>(length);
    for (std::size_t k = 0; k < length / 2; ++k) {
      const Complex turn = std::polar(1.0, angle * static_cast<double>(k));
      for (std::size_t start = k; start < size; start += length) {
        const Complex even = series[start];
        const Complex odd = turn * series[start + length / 2];
        series[start] = even + odd;
        series[start + length / 2] = even - odd;
      }
    }
  }
}

}  // namespace

std::vector<double> autocovariances(std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  std::vector<Complex> series(
      std::bit_ceil(2 * values.size()));  // with zeros behind, so that no end meets the start
  for (std::size_t i = 0; i < values.size(); ++i) series[i] = values[i] - mean;
  transform_series(series, -1);
  for (Complex& each : series) each = std::norm(each);
  transform_series(series, 1);
  std::vector<double> covariances(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    covariances[i] = series[i].real() / (static_cast<double>(series.size()) * count);
  return covariances;
}

}  // namespace solitaire
