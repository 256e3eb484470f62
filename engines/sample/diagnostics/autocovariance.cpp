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

/// The first half of the roots of unity of that order.
std::vector<Complex> roots_of_unity(std::size_t order, int direction) {
  std::vector<Complex> roots(order / 2);
  for (std::size_t k = 0; k < roots.size(); ++k)
    roots[k] = std::polar(
        1.0, direction * 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(order));
  return roots;
}

/// Makes a transform of the transforms of the even and the odd members of a series, which are that long. The
/// product is written out, since that of complex numbers looks for infinities.
void combine(Complex* series, std::size_t half, const Complex* turns, std::size_t stride) {
  for (std::size_t k = 0; k < half; ++k) {
    const Complex turn = turns[k * stride], even = series[k], last = series[k + half];
    const Complex odd(turn.real() * last.real() - turn.imag() * last.imag(),
                      turn.real() * last.imag() + turn.imag() * last.real());
    series[k] = even + odd;
    series[k + half] = even - odd;
  }
}

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
  const std::vector<Complex> turns = roots_of_unity(size, direction);
  for (std::size_t length = 2; length <= size; length *= 2)
    for (std::size_t start = 0; start < size; start += length)
      combine(&series[start], length / 2, turns.data(), size / length);
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
