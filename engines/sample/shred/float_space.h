#pragma once
#include <span>
#include <vector>

#include "engines/sample/coordinate.h"
#include "kernel/kernel.h"

namespace solitaire {

/// The floats of a kernel together, as a point whose numbers are their coordinates.
class FloatSpace {
 public:
  explicit FloatSpace(Kernel& kernel);

  std::size_t size() const { return coordinates_.size(); }
  /// Where the floats are in the present state.
  std::vector<double> present() const;
  /// The logarithm of the density of coordinates at a point, less that of the present point, and its slopes
  /// there. Minus infinity where the execution is impossible or takes another path; then there are no slopes.
  double height(std::span<const double> at, std::span<double> slopes);
  /// Makes that the present point. It has to be possible.
  void move_to(std::span<const double> at);

 private:
  Kernel::Outcome propose(std::span<const double> at);

  Kernel& kernel_;
  std::vector<Coordinate> coordinates_;
  std::vector<double> values_;
  double present_derivative_ = 0;  // the logarithm of that of the values by the coordinates
};

}  // namespace solitaire
