#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/random.h"

namespace solitaire {

/// A walk of several floats together, by normal steps that lie as the floats do: by the covariances that the
/// warm-up shows (Haario, Saksman and Tamminen 2001). Where floats hang together, as a slope and an intercept
/// far from the data, single ones can hardly move.
class JointWalk {
 public:
  explicit JointWalk(std::size_t size) : size_(size), sums_(size, 0.0), products_(size * size, 0.0) {}

  // During the warm-up:

  /// Is told where the floats are, once in a sweep.
  void watch(std::span<const double> at);
  /// Tunes how far steps go, until 0.3 of them are taken.
  void learn(double acceptance);

  /// Returns true if there are steps to go: enough was seen, and some of the floats hang together.
  bool ready() const { return !factor_.empty(); }
  /// Another place; the way back is as probable.
  std::vector<double> propose(std::span<const double> at, RandomStream& stream) const;

 private:
  void take_covariances();
  double covariance(std::size_t i, std::size_t j) const;
  bool correlated() const;

  std::size_t size_;
  std::uint64_t seen_ = 0, enough_ = 60;
  std::vector<double> sums_, products_, origin_;
  std::vector<double> factor_;  // of the covariances, lower triangular (Cholesky)
  double log_scale_ = 0, told_ = 0;
};

}  // namespace solitaire
