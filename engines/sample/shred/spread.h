#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace solitaire {

/// How floats lie, as the warm-up shows: their covariances, or, where they are many, their variances alone.
class Spread {
 public:
  explicit Spread(std::size_t size);

  /// Is told where the floats are once single ones have moved, and then, once in a sweep, where they are when
  /// all have moved together, if they do. The second returns true if the spread is another from now on.
  void watch_single_moves(std::span<const double> at);
  bool watch(std::span<const double> at);
  /// Returns false until enough was seen, or where some float never moved.
  bool known() const { return known_; }
  /// Returns true if some of the floats hang together so that single ones hardly move.
  bool hangs_together() const { return correlated_ && slow_; }

  /// Adds S x to `sum`, where the spread is that of S x if x are independent standard normal numbers.
  void add_scaled(std::span<const double> x, std::span<double> sum) const;
  /// The slopes along x of a function whose slopes along the floats are these.
  void scale_slopes(std::span<const double> slopes, std::vector<double>& made) const;

 private:
  void take();
  double covariance(std::size_t i, std::size_t j) const;
  /// Where the covariance of i with j stands, j <= i.
  std::size_t place(std::size_t i, std::size_t j) const { return dense_ ? i * size_ + j : i; }
  std::size_t first_of_row(std::size_t i) const { return dense_ ? 0 : i; }

  std::size_t size_;
  bool dense_;
  std::uint64_t seen_ = 0, enough_ = 60;
  std::vector<double> sums_, products_, origin_;
  std::vector<double> factor_;        // of the covariances, lower triangular (Cholesky)
  std::vector<double> last_;          // where the floats were told to be last
  std::vector<double> single_moves_;  // the sums of their squares
  bool known_ = false, correlated_ = false, slow_ = false;
};

}  // namespace solitaire
