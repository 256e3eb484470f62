#include "engines/sample/float_space.h"

#include <cmath>

namespace solitaire {
namespace {

/// By how much a value, and the logarithm of its derivative, grow with the coordinate.
struct Slopes {
  double value = 1;
  double log_derivative = 0;
};

Slopes slopes_of(Coordinate coordinate, double value) {
  if (coordinate == Coordinate::kPlain) return {};
  if (coordinate == Coordinate::kLog) return {value, 1};
  return {value * (1 - value), 1 - 2 * value};
}

}  // namespace

FloatSpace::FloatSpace(Kernel& kernel) : kernel_(kernel), values_(kernel.floats().size()) {
  for (const ChoiceNumber each : kernel.floats()) {
    coordinates_.push_back(coordinate_of(kernel.program().choices[each].distribution.family));
    present_derivative_ += log_derivative(coordinates_.back(), kernel.value(each).f);
  }
}

std::vector<double> FloatSpace::present() const {
  std::vector<double> at;
  for (std::size_t i = 0; i < size(); ++i)
    at.push_back(to_coordinate(coordinates_[i], kernel_.value(kernel_.floats()[i]).f));
  return at;
}

Kernel::Outcome FloatSpace::propose(std::span<const double> at) {
  for (std::size_t i = 0; i < size(); ++i) values_[i] = from_coordinate(coordinates_[i], at[i]);
  return kernel_.propose_floats(values_);
}

double FloatSpace::height(std::span<const double> at, std::span<double> slopes) {
  if (propose(at) != Kernel::Outcome::kScored) return -HUGE_VAL;
  double height = kernel_.difference() - present_derivative_;
  for (std::size_t i = 0; i < size(); ++i) {
    height += log_derivative(coordinates_[i], values_[i]);
    const Slopes along = slopes_of(coordinates_[i], values_[i]);
    slopes[i] = kernel_.slope(i) * along.value + along.log_derivative;
    if (!std::isfinite(slopes[i])) return -HUGE_VAL;
  }
  return std::isnan(height) ? -HUGE_VAL : height;
}

void FloatSpace::move_to(std::span<const double> at) {
  if (propose(at) == Kernel::Outcome::kScored) kernel_.accept();
}

}  // namespace solitaire
