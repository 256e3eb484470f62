#include "engines/sample/shred/trajectory.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tracegraph/drawing.h"

namespace solitaire {
namespace {

/// A trajectory has at most 2 to this power of steps.
constexpr int kMostDoublings = 10;
/// Where the energy is off by so much, the steps are too long for what the density is like, and the way ends.
constexpr double kMostError = 1000;

double product(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double log_sum(double a, double b) {
  const double high = std::max(a, b);
  return high + std::log(std::exp(a - high) + std::exp(b - high));
}

}  // namespace

Trajectory::Trajectory(FloatSpace& space, const Spread& spread, double step_size, RandomStream& stream)
    : space_(space),
      spread_(spread),
      step_size_(step_size),
      stream_(stream),
      origin_(space.present()),
      slopes_(space.size()) {}

/// Finds the height and the slopes at a point. Returns false if the density is 0 there.
bool Trajectory::look(Point& point) {
  point.height = space_.height(place(point.at), slopes_);
  if (point.height == -HUGE_VAL) return false;
  spread_.scale_slopes(slopes_, point.slopes);
  return true;
}

/// Where the floats are at a point.
const std::vector<double>& Trajectory::place(const std::vector<double>& at) {
  place_ = origin_;
  spread_.add_scaled(at, place_);
  return place_;
}

/// The leapfrog method, which is exact enough over many steps, and of which a step back leads back.
bool Trajectory::step(const Point& from, double time, Point& to) {
  to = from;
  for (std::size_t i = 0; i < to.at.size(); ++i) {
    to.momentum[i] += 0.5 * time * to.slopes[i];
    to.at[i] += time * to.momentum[i];
  }
  if (!look(to)) return false;
  for (std::size_t i = 0; i < to.at.size(); ++i) to.momentum[i] += 0.5 * time * to.slopes[i];
  return true;
}

/// Makes a part of 2^depth points that follow a point. Returns false if it turns back or leaves the density,
/// and so ends the trajectory without counting.
bool Trajectory::build(const Point& from, double time, int depth, Part& part) {
  if (depth > 0) return build_two(from, time, depth, part);
  ++points_;
  if (!step(from, time, part.low)) return false;
  const double energy = 0.5 * product(part.low.momentum, part.low.momentum) - part.low.height;
  part.log_weight = first_energy_ - energy;
  if (!(part.log_weight > -kMostError)) {
    diverged_ = true;
    return false;
  }
  acceptance_ += std::min(1.0, std::exp(part.log_weight));
  part.high = part.low;
  part.momentum_sum = part.low.momentum;
  part.drawn = part.low.at;
  return true;
}

bool Trajectory::build_two(const Point& from, double time, int depth, Part& part) {
  Part second;
  const bool forward = time > 0;
  if (!build(from, time, depth - 1, part)) return false;
  if (!build(forward ? part.high : part.low, time, depth - 1, second)) return false;
  const double share = second.log_weight - log_sum(part.log_weight, second.log_weight);
  return join(part, second, forward, std::exp(share));
}

/// Adds a part at one end, and draws its point with that probability. Returns false if the way turns back in
/// all of it, or where the two meet.
bool Trajectory::join(Part& all, Part& more, bool forward, double probability) {
  if (stream_.uniform() < probability) all.drawn = std::move(more.drawn);
  all.log_weight = log_sum(all.log_weight, more.log_weight);
  Part& early = forward ? all : more;
  Part& late = forward ? more : all;
  // Of two sums of momenta that are one behind the other.
  const auto between = [](const Point& a, const Point& b, const std::vector<double>& first,
                          const std::vector<double>& second) {
    return product(a.momentum, first) + product(a.momentum, second) > 0 &&
           product(b.momentum, first) + product(b.momentum, second) > 0;
  };
  const bool goes_on = between(early.low, late.high, early.momentum_sum, late.momentum_sum) &&
                       between(early.low, late.low, early.momentum_sum, late.low.momentum) &&
                       between(early.high, late.high, late.momentum_sum, early.high.momentum);
  for (std::size_t i = 0; i < all.momentum_sum.size(); ++i) all.momentum_sum[i] += more.momentum_sum[i];
  (forward ? all.high : all.low) = std::move(forward ? more.high : more.low);
  return goes_on;
}

bool Trajectory::run() {
  Part all;
  all.low.at.assign(space_.size(), 0.0);
  for (std::size_t i = 0; i < space_.size(); ++i) all.low.momentum.push_back(draw_normal(stream_));
  if (!look(all.low)) return false;
  first_energy_ = 0.5 * product(all.low.momentum, all.low.momentum) - all.low.height;
  all.high = all.low;
  all.momentum_sum = all.low.momentum;
  all.drawn = all.low.at;
  for (int depth = 0; depth < kMostDoublings; ++depth) {
    const bool forward = stream_.below(2) == 0;
    Part more;
    if (!build(forward ? all.high : all.low, forward ? step_size_ : -step_size_, depth, more)) break;
    if (!join(all, more, forward, std::exp(more.log_weight - all.log_weight))) break;
  }
  const bool moves = std::any_of(all.drawn.begin(), all.drawn.end(), [](double x) { return x != 0; });
  if (moves) space_.move_to(place(all.drawn));
  return moves;
}

}  // namespace solitaire
