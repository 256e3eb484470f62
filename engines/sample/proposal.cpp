#include "engines/sample/proposal.h"

#include <algorithm>
#include <cmath>

#include "engines/sample/coordinate.h"
#include "tracegraph/drawing.h"

namespace solitaire {
namespace {

using Family = Distribution::Family;

constexpr double kWantedAcceptance = 0.44;

}  // namespace

/// Half of the steps go anywhere, and half close by: the first leave a mode, the second explore it.
Proposal Proposer::propose(AddressId address, const Distribution& distribution, TypedScalar value) {
  if (distribution.family == Family::kFlip) return {TypedScalar::of(value.as_int() == 0), 0, Move::kOther};
  const bool has_near =
      !distribution.is_finite() || (distribution.family == Family::kRange && distribution.size() > 4);
  if (!has_near || stream_.below(2) == 0) return anywhere(distribution, value);
  if (distribution.type() != Type::kFloat) return neighbour(distribution, value);
  return walk(scale(address).factor, distribution, value);
}

Proposal Proposer::anywhere(const Distribution& distribution, TypedScalar value) {
  if (!distribution.is_finite()) return from_prior(distribution, value);
  return distribution.size() == 1 ? Proposal{value, 0, Move::kOther} : other(distribution, value);
}

Proposal Proposer::from_prior(const Distribution& distribution, TypedScalar value) {
  const TypedScalar proposed = distribution.sample(stream_);
  return {proposed, distribution.log_density_difference(value, proposed), Move::kPrior};
}

Proposal Proposer::other(const Distribution& distribution, TypedScalar value) {
  const std::uint64_t present = distribution.number(value.as_int()), others = distribution.size() - 1;
  std::uint64_t number = others == 1 ? 0 : any_of(others);
  if (number >= present) ++number;
  return {distribution.typed(distribution.value(number)), 0, Move::kOther};
}

std::uint64_t Proposer::any_of(std::uint64_t count) {
  return count > UINT32_MAX ? stream_.below(count) : stream_.pick(static_cast<std::uint32_t>(count));
}

/// Goes up or down by 1, 2, 4 or 8 steps; what leads outside is impossible, and so refused later.
Proposal Proposer::neighbour(const Distribution& distribution, TypedScalar value) {
  const std::int64_t distance = distribution.step << stream_.below(4);
  const std::int64_t sign = stream_.below(2) == 0 ? 1 : -1;
  return {TypedScalar::of(value.as_int() + sign * distance), 0, Move::kNeighbour};
}

/// A normal step in the coordinate. What is symmetric there is not so for the value itself: the ratio of the
/// densities is that of the derivatives of the value by the coordinate.
Proposal Proposer::walk(double scale, const Distribution& distribution, TypedScalar value) {
  const double x = value.as_float();
  const double step = scale * usual_step(distribution) * draw_normal(stream_);
  const Coordinate coordinate(distribution);
  const double proposed = coordinate.value(coordinate.of(x) + step);
  const double log_ratio = coordinate.log_derivative(proposed) - coordinate.log_derivative(x);
  return {TypedScalar::of(proposed), log_ratio, Move::kWalk};
}

void Proposer::learn(AddressId address, double acceptance) {
  Scale& scale = this->scale(address);
  scale.told += 1;
  scale.log_factor += 2 / std::sqrt(scale.told) * (acceptance - kWantedAcceptance);
  scale.log_factor = std::clamp(scale.log_factor, -40.0, 10.0);
  scale.factor = std::exp(scale.log_factor);
}

Proposer::Scale& Proposer::scale(AddressId address) {
  if (scales_.size() <= address.index) scales_.resize(address.index + 1);
  return scales_[address.index];
}

}  // namespace solitaire
