#include "engines/sample/shred/joint_move.h"

#include <cmath>

#include "engines/sample/shred/trajectory.h"

namespace solitaire {
namespace {

/// Of independent standard normal numbers the best one shrinks so with their number (Beskos and others 2013).
double usual_step_size(std::size_t size) { return std::pow(static_cast<double>(size), -0.25); }

}  // namespace

JointMove::JointMove(std::size_t size, bool always)
    : spread_(size), always_(always), step_size_(usual_step_size(size)) {}

JointMove::Result JointMove::move(Kernel& kernel, RandomStream& stream, bool learns) {
  FloatSpace space(kernel);
  Trajectory trajectory(space, spread_, step_size_.size(), stream);
  const bool moved = trajectory.run();
  if (learns) step_size_.learn(trajectory.acceptance());
  return {moved, trajectory.diverged()};
}

void JointMove::watch(Kernel& kernel) {
  const FloatSpace space(kernel);
  if (spread_.watch(space.present())) step_size_ = StepSize(step_size_.learned());
}

}  // namespace solitaire
