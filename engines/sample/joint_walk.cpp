#include "engines/sample/joint_walk.h"

#include <algorithm>
#include <cmath>

#include "tracegraph/drawing.h"

namespace solitaire {
namespace {

constexpr double kWantedJointAcceptance = 0.3;
/// Where no two floats are more correlated, single ones get along. Judgement.
constexpr double kLeastCorrelation = 0.5;

/// The lower triangular matrix whose product with its transpose is that; nothing if there is none.
std::vector<double> cholesky(const std::vector<double>& matrix, std::size_t size) {
  std::vector<double> factor(size * size, 0.0);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = matrix[i * size + j];
      for (std::size_t k = 0; k < j; ++k) rest -= factor[i * size + k] * factor[j * size + k];
      if (i != j) {
        factor[i * size + j] = rest / factor[j * size + j];
      } else if (rest > 0) {
        factor[i * size + i] = std::sqrt(rest);
      } else {
        return {};
      }
    }
  }
  return factor;
}

}  // namespace

/// What was seen is forgotten each time that the covariances are taken from it, and then twice as much is
/// seen, so that the way from the start does not count in the end.
void JointWalk::watch(std::span<const double> at) {
  if (origin_.empty()) origin_.assign(at.begin(), at.end());
  for (std::size_t i = 0; i < size_; ++i) {
    sums_[i] += at[i] - origin_[i];
    for (std::size_t j = 0; j <= i; ++j)
      products_[i * size_ + j] += (at[i] - origin_[i]) * (at[j] - origin_[j]);
  }
  if (++seen_ < enough_) return;
  take_covariances();
  origin_.clear();
  std::fill(sums_.begin(), sums_.end(), 0.0);
  std::fill(products_.begin(), products_.end(), 0.0);
  seen_ = 0;
  enough_ *= 2;
}

double JointWalk::covariance(std::size_t i, std::size_t j) const {
  const auto seen = static_cast<double>(seen_);
  return (products_[std::max(i, j) * size_ + std::min(i, j)] - sums_[i] * sums_[j] / seen) / (seen - 1);
}

bool JointWalk::correlated() const {
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::abs(covariance(i, j)) > kLeastCorrelation * std::sqrt(covariance(i, i) * covariance(j, j)))
        return true;
  return false;
}

void JointWalk::take_covariances() {
  // With steps between single floats alone, correlated ones look less spread than they are, so that scales
  // that were learned do not go with other covariances.
  factor_.clear();
  log_scale_ = std::log(2.4 / std::sqrt(static_cast<double>(size_)));
  told_ = 0;
  if (!correlated()) return;
  std::vector<double> matrix(size_ * size_);
  for (std::size_t i = 0; i < size_; ++i) {
    for (std::size_t j = 0; j < size_; ++j) matrix[i * size_ + j] = covariance(i, j);
    matrix[i * size_ + i] *= 1 + 1e-9;  // so that rounding leaves it positive definite
  }
  factor_ = cholesky(matrix, size_);
}

void JointWalk::learn(double acceptance) {
  told_ += 1;
  log_scale_ += 2 / std::sqrt(told_ + 10) * (acceptance - kWantedJointAcceptance);
}

std::vector<double> JointWalk::propose(std::span<const double> at, RandomStream& stream) const {
  std::vector<double> normal(size_), to(at.begin(), at.end());
  for (double& each : normal) each = draw_normal(stream);
  const double scale = std::exp(log_scale_);
  for (std::size_t i = 0; i < size_; ++i)
    for (std::size_t j = 0; j <= i; ++j) to[i] += scale * factor_[i * size_ + j] * normal[j];
  return to;
}

}  // namespace solitaire
