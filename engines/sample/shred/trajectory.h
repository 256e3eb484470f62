#pragma once
#include <vector>

#include "base/random.h"
#include "engines/sample/shred/float_space.h"
#include "engines/sample/shred/spread.h"

namespace solitaire {

/// A draw of all floats of a kernel together by the No-U-Turn sampler (Hoffman and Gelman 2014), with the
/// states of a trajectory drawn by their weights (Betancourt 2017, appendix A): the floats get a random
/// momentum and move by the slopes of the density, as a ball does on its landscape, forward and backward in
/// time, until the way turns back. One of the points on the way is what is drawn.
///
/// It moves in numbers in which the floats are spread as independent standard normal ones are, as far as is
/// known.
class Trajectory {
 public:
  Trajectory(FloatSpace& space, const Spread& spread, double step_size, RandomStream& stream);

  /// Moves the floats. Returns true if they are not where they were.
  bool run();
  /// Returns true if the way ended where its steps were too long for what the density is like.
  bool diverged() const { return diverged_; }
  /// The mean over the trajectory of the probability with which a point would be accepted by itself.
  double acceptance() const { return points_ == 0 ? 0 : acceptance_ / static_cast<double>(points_); }

 private:
  struct Point {
    std::vector<double> at, momentum, slopes;
    double height = 0;
  };
  /// A part of the trajectory.
  struct Part {
    Point low, high;                   // its ends, in time
    std::vector<double> momentum_sum;  // over its points
    std::vector<double> drawn;         // one of its points
    double log_weight = 0;             // of all of them
  };

  const std::vector<double>& place(const std::vector<double>& at);
  bool look(Point& point);
  bool step(const Point& from, double time, Point& to);
  bool build(const Point& from, double time, int depth, Part& part);
  bool build_two(const Point& from, double time, int depth, Part& part);
  bool join(Part& all, Part& more, bool forward, double probability);

  FloatSpace& space_;
  const Spread& spread_;
  double step_size_;
  RandomStream& stream_;
  std::vector<double> origin_;
  std::vector<double> place_, slopes_;  // of the floats, where the last point is
  double first_energy_ = 0;
  double acceptance_ = 0;
  std::uint64_t points_ = 0;
  bool diverged_ = false;
};

}  // namespace solitaire
