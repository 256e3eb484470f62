#include "engines/sample/shred/block_draw.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "tracegraph/drawing.h"

namespace solitaire {

bool BlockDraw::look(Kernel& kernel) {
  const std::vector<ChoiceNumber>& choices = kernel.program().block.choices;
  const std::size_t size = choices.size();
  const std::span<const double> numbers = kernel.block_numbers();
  if (!factorise(numbers.first(numbers.size() - size))) return false;
  slopes_.assign(numbers.end() - static_cast<std::ptrdiff_t>(size), numbers.end());
  present_.clear();
  for (std::size_t i = 0; i < size; ++i) {
    present_.push_back(kernel.value(choices[i]).f);
    for (std::size_t j = 0; j < i; ++j) slopes_[i] -= factor(i, j) * slopes_[j];
    slopes_[i] /= factor(i, i);
  }
  return std::all_of(slopes_.begin(), slopes_.end(), [](double each) { return std::isfinite(each); });
}

/// The precision is often that of the time before.
bool BlockDraw::factorise(std::span<const double> precision) {
  if (std::equal(precision.begin(), precision.end(), precision_.begin(), precision_.end())) return true;
  precision_.clear();
  factor_.assign(precision.begin(), precision.end());
  log_determinant_ = 0;
  for (std::size_t i = 0; i * (i + 1) / 2 < factor_.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k < j; ++k) factor(i, j) -= factor(i, k) * factor(j, k);
      if (j < i) factor(i, j) /= factor(j, j);
    }
    const double square = factor(i, i);
    if (!(square > 0) || !std::isfinite(square)) return false;
    factor(i, i) = std::sqrt(square);
    log_determinant_ += std::log(factor(i, i));
  }
  precision_.assign(precision.begin(), precision.end());
  return true;
}

/// Where x is the present point, the mean is x + L'^-1 s, and L'^-1 z is distributed about it if z are
/// independent standard normal numbers.
std::span<const double> BlockDraw::draw(RandomStream& stream) {
  drawn_ = slopes_;
  for (double& each : drawn_) each += draw_normal(stream);
  for (std::size_t i = drawn_.size(); i-- > 0;) {
    for (std::size_t k = i + 1; k < drawn_.size(); ++k) drawn_[i] -= factor(k, i) * drawn_[k];
    drawn_[i] /= factor(i, i);
  }
  for (std::size_t i = 0; i < drawn_.size(); ++i) drawn_[i] += present_[i];
  return drawn_;
}

double BlockDraw::log_density() const {
  const double square = std::inner_product(slopes_.begin(), slopes_.end(), slopes_.begin(), 0.0);
  const auto size = static_cast<double>(slopes_.size());
  return log_determinant_ - 0.5 * (square + size * std::log(2 * std::numbers::pi));
}

}  // namespace solitaire
