#pragma once
#include <unordered_map>

#include "base/random.h"
#include "kernel/kernel.h"
#include "tracegraph/address.h"

namespace solitaire {

/// Draws a choice anew by slice sampling (Neal 2003, section 4): picks a level below the density at the
/// present value, and then one of the values at which the density is above that level. Nothing is ever
/// refused, and nothing has to be known of the density. (The slices of a trace have nothing to do with it but
/// the name.)
///
/// Floats move in their coordinate, and ints as the floats from them up to the next one, which share their
/// density.
class SliceSampler {
 public:
  explicit SliceSampler(RandomStream& stream) : stream_(stream) {}

  /// The choice has more than one value, and no branch depends on it. The kernel scored the value that is
  /// returned last of all, unless it is the present one. With `learns`, the width of the choice's first
  /// interval is tuned, until it has to grow about as often as to shrink: during warm-up only.
  Scalar draw(Kernel& kernel, ChoiceNumber choice, bool learns);

 private:
  class Line;
  struct Width {
    double log_factor = 0;
    double told = 0;
  };
  struct Interval {
    double low, high;
  };

  Interval around(Line& line, double level, double width, int& growths);
  void learn(Width& width, int growths, int shrinks);

  RandomStream& stream_;
  std::unordered_map<AddressId, Width> widths_;
};

}  // namespace solitaire
