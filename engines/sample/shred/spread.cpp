#include "engines/sample/shred/spread.h"

#include <algorithm>
#include <cmath>

#include "engines/tuning.h"

namespace solitaire {
namespace {

/// Where no two floats are more correlated, single ones get along. Judgement.
constexpr double kLeastCorrelation = 0.5;
/// Where the correlation of a float with itself a sweep later is no larger, single moves are worth more in
/// the same time: ten draws and more take as long as a trajectory. Judgement.
constexpr double kMostPersistence = 0.9;
/// As Stan does (its reference manual, "Euclidean metric"), but for each float on its own scale.
constexpr double kCaution = 1e-3;

}  // namespace

Spread::Spread(std::size_t size)
    : size_(size),
      dense_(size <= tuning::kMostCovariances),
      sums_(size, 0.0),
      products_(dense_ ? size * size : size, 0.0),
      factor_(products_.size(), 0.0),
      single_moves_(size, 0.0) {}

void Spread::watch_single_moves(std::span<const double> at) {
  if (last_.empty()) return;
  for (std::size_t i = 0; i < size_; ++i) single_moves_[i] += (at[i] - last_[i]) * (at[i] - last_[i]);
}

/// What was seen is forgotten each time that the covariances are taken from it, and then twice as much is
/// seen, so that the way from the start does not count in the end.
bool Spread::watch(std::span<const double> at) {
  if (origin_.empty()) origin_.assign(at.begin(), at.end());
  for (std::size_t i = 0; i < size_; ++i) {
    sums_[i] += at[i] - origin_[i];
    for (std::size_t j = first_of_row(i); j <= i; ++j)
      products_[place(i, j)] += (at[i] - origin_[i]) * (at[j] - origin_[j]);
  }
  last_.assign(at.begin(), at.end());
  if (++seen_ < enough_) return false;
  take();
  origin_.clear();
  std::fill(sums_.begin(), sums_.end(), 0.0);
  std::fill(products_.begin(), products_.end(), 0.0);
  std::fill(single_moves_.begin(), single_moves_.end(), 0.0);
  seen_ = 0;
  enough_ *= 2;
  return true;
}

/// Covariances are taken for a little smaller than they look, the more so the fewer states were seen for so
/// many floats, so that there is a factor.
double Spread::covariance(std::size_t i, std::size_t j) const {
  const auto seen = static_cast<double>(seen_);
  const double found = (products_[place(i, j)] - sums_[i] * sums_[j] / seen) / (seen - 1);
  const auto size = static_cast<double>(size_);
  return i == j ? found : found * (1 - kCaution * size / (seen + size));
}

/// The factor is found a row after the other; of independent floats it is their standard deviations.
void Spread::take() {
  known_ = true;
  correlated_ = slow_ = false;
  for (std::size_t i = 0; i < size_; ++i) {
    // A move is the difference of two states, whose variance is twice that of one, less twice their
    // covariance.
    const double move = single_moves_[i] / static_cast<double>(seen_);
    if (move < 2 * (1 - kMostPersistence) * covariance(i, i)) slow_ = true;
    for (std::size_t j = first_of_row(i); j <= i; ++j) {
      double rest = covariance(i, j);
      if (i != j && std::abs(rest) > kLeastCorrelation * std::sqrt(covariance(i, i) * covariance(j, j)))
        correlated_ = true;
      for (std::size_t k = first_of_row(i); k < j; ++k) rest -= factor_[place(i, k)] * factor_[place(j, k)];
      if (i == j && !(rest > 0)) known_ = false;
      factor_[place(i, j)] = i == j ? std::sqrt(rest) : rest / factor_[place(j, j)];
    }
  }
}

void Spread::add_scaled(std::span<const double> x, std::span<double> sum) const {
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = first_of_row(i); j <= i; ++j) sum[i] += factor_[place(i, j)] * x[j];
}

void Spread::scale_slopes(std::span<const double> slopes, std::vector<double>& made) const {
  made.assign(size_, 0.0);
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = first_of_row(i); j <= i; ++j) made[j] += factor_[place(i, j)] * slopes[i];
}

}  // namespace solitaire
