#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "base/random.h"
#include "kernel/kernel.h"

namespace solitaire {

/// The distribution of the floats of a kernel's block, given all other choices: a normal one of all of them
/// together (ScoreProgram::Block).
class BlockDraw {
 public:
  /// Finds the distribution. Returns false where there is none, as where the density has no end along some
  /// direction.
  bool look(Kernel& kernel);
  /// Values of the floats, drawn from it. They stand until this is called another time.
  std::span<const double> draw(RandomStream& stream);
  /// The logarithm of its density where the floats were when it was found.
  double log_density() const;

 private:
  bool factorise(std::span<const double> precision);
  double& factor(std::size_t i, std::size_t j) { return factor_[i * (i + 1) / 2 + j]; }

  std::vector<double> present_;
  std::vector<double> precision_;  // of which the factor is known
  std::vector<double> factor_;     // L, lower triangular, where L L' is the precision (Cholesky)
  std::vector<double> slopes_;     // s, where L s are the slopes of the density's logarithm
  std::vector<double> drawn_;
  double log_determinant_ = 0;  // of L
};

}  // namespace solitaire
