#include "engines/sample/shred/float_space.h"

#include <cmath>

namespace solitaire {
namespace {

/// Between ends that move with other floats, a float moves as it is: its coordinate would move with them.
Coordinate coordinate_of(const ScoreProgram::Choice& choice) {
  const bool has_ends = choice.distribution.family == Distribution::Family::kUniform;
  return has_ends && !choice.fixed_parameters ? Coordinate() : Coordinate(choice.distribution);
}

}  // namespace

FloatSpace::FloatSpace(Kernel& kernel) : kernel_(kernel), values_(kernel.floats().size()) {
  for (const ChoiceNumber each : kernel.floats()) {
    coordinates_.push_back(coordinate_of(kernel.program().choices[each]));
    present_derivative_ += coordinates_.back().log_derivative(kernel.value(each).f);
  }
}

std::vector<double> FloatSpace::present() const {
  std::vector<double> at;
  for (std::size_t i = 0; i < size(); ++i)
    at.push_back(coordinates_[i].of(kernel_.value(kernel_.floats()[i]).f));
  return at;
}

Kernel::Outcome FloatSpace::propose(std::span<const double> at) {
  for (std::size_t i = 0; i < size(); ++i) values_[i] = coordinates_[i].value(at[i]);
  return kernel_.propose_floats(values_);
}

double FloatSpace::height(std::span<const double> at, std::span<double> slopes) {
  if (propose(at) != Kernel::Outcome::kScored) return -HUGE_VAL;
  double height = kernel_.difference() - present_derivative_;
  for (std::size_t i = 0; i < size(); ++i) {
    height += coordinates_[i].log_derivative(values_[i]);
    const Coordinate::Slopes along = coordinates_[i].slopes(values_[i]);
    slopes[i] = kernel_.slope(i) * along.value + along.log_derivative;
    if (!std::isfinite(slopes[i])) return -HUGE_VAL;
  }
  return std::isnan(height) ? -HUGE_VAL : height;
}

void FloatSpace::move_to(std::span<const double> at) {
  if (propose(at) == Kernel::Outcome::kScored) kernel_.accept();
}

}  // namespace solitaire
