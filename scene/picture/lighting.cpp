#include "scene/picture/lighting.h"

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "scene/sun.h"

namespace solitaire {
namespace {

constexpr float kSunRadius = 0.11F;  // the tangent of the angle under which it is seen
constexpr Vector kSunColor{1.80F, 1.68F, 1.48F};
constexpr Vector kZenith{1.00F, 1.05F, 1.14F};
constexpr Vector kHorizon{0.66F, 0.67F, 0.71F};
constexpr Vector kGround{0.36F, 0.35F, 0.335F};
/// What surfaces around pass on, in place of the light that they take away.
constexpr Vector kBounce{0.10F, 0.093F, 0.087F};
constexpr std::size_t kCells = 8;  // samples are spread over a square of kCells x kCells, one in each cell

/// Returns a number of 0..1, of so few digits that all machines agree about it.
double fraction(RandomStream& random) { return static_cast<double>(random.below(1 << 20)) / (1 << 20); }

struct DiscPoint {
  double x, y;
};

/// Maps a square to the unit disc so that equal areas stay equal: the concentric map of Shirley and Chiu
/// (1997). The result has six digits, on which the sines of all processors agree.
DiscPoint on_disc(double u, double v) {
  const double x = 2 * u - 1, y = 2 * v - 1;
  if (x == 0 && y == 0) return {0, 0};
  const bool wide = std::abs(x) > std::abs(y);
  const double radius = wide ? x : y;
  const double angle =
      wide ? std::numbers::pi / 4 * y / x : std::numbers::pi / 2 - std::numbers::pi / 4 * x / y;
  return {rounded(radius * std::cos(angle), 6), rounded(radius * std::sin(angle), 6)};
}

/// Calls use(group, number in the group, point) for points all over the unit disc. The cells of a group lie
/// in four quarters of the square.
template <typename Use>
void for_each_sample(std::uint64_t stream, const Use& use) {
  RandomStream random(0, Purpose::kPicture, stream);
  for (std::size_t row = 0; row < kCells; ++row) {
    for (std::size_t column = 0; column < kCells; ++column) {
      const std::size_t group = row % 4 * 4 + column % 4, number = row / 4 * 2 + column / 4;
      const double u = (static_cast<double>(column) + fraction(random)) / kCells;
      const double v = (static_cast<double>(row) + fraction(random)) / kCells;
      use(group, number, on_disc(u, v));
    }
  }
}

/// The axes of a frame whose y axis is a normal.
struct Frame {
  Vector x, y, z;

  /// Builds the frame as Duff and others (2017) do, without a branch that could differ between neighbours.
  explicit Frame(const Vector& normal) : y(normal) {
    const float sign = std::copysign(1.0F, normal.z);
    const float a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
    x = {1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
    z = {b, sign + normal.y * normal.y * a, -normal.y};
  }

  Vector from(const Vector& v) const { return x * v.x + y * v.y + z * v.z; }
};

}  // namespace

Vector Lighting::to_sun() { return to_vector(solitaire::to_sun()); }
Vector Lighting::sun_color() { return kSunColor; }

Vector Lighting::sky(const Vector& direction) {
  return direction.y < 0 ? kGround : mixed(kHorizon, kZenith, direction.y);
}

Lighting::Lighting(std::size_t rounds) {
  for (std::size_t number = 0; number < rounds; ++number) add_round(number);
  open_.sun = 1;
  for (const auto& group : rounds_.front().sky) {
    for (const Vector& direction : group) open_.ambient += sky(direction) * (1.0F / (kGroups * kPerGroup));
  }
}

void Lighting::add_round(std::uint64_t number) {
  Round& round = rounds_.emplace_back();
  for_each_sample(2 * number, [&](std::size_t group, std::size_t each, const DiscPoint& point) {
    const double up = std::sqrt(std::max(0.0, 1 - point.x * point.x - point.y * point.y));
    round.sky[group][each] = to_vector({point.x, up, point.y});
  });
  const Frame sun(to_sun());
  for_each_sample(2 * number + 1, [&](std::size_t group, std::size_t each, const DiscPoint& point) {
    const auto x = static_cast<float>(point.x), z = static_cast<float>(point.y);
    round.sun[group][each] = normalized(sun.from({x * kSunRadius, 1, z * kSunRadius}));
  });
}

Light Lighting::sample(const RayScene& scene, const Vector& point, const Vector& normal, float lift,
                       std::size_t group) const {
  const float share = 1.0F / static_cast<float>(rounds_.size());
  const Vector origin = point + normal * lift;
  Light light;
  for (const Round& round : rounds_) {
    const Light each = sample(round, scene, origin, normal, group);
    light.sun += each.sun * share;
    light.ambient += each.ambient * share;
  }
  return light;
}

Light Lighting::sample(const Round& round, const RayScene& scene, const Vector& origin, const Vector& normal,
                       std::size_t group) const {
  constexpr float kShare = 1.0F / kPerGroup;
  Light light;
  const Frame frame(normal);
  std::array<Vector, kPerGroup> directions{};
  for (std::size_t i = 0; i < kPerGroup; ++i) directions[i] = frame.from(round.sky[group][i]);
  const auto sky_free = scene.are_free(origin, directions);
  for (std::size_t i = 0; i < kPerGroup; ++i)
    light.ambient += (sky_free[i] ? sky(directions[i]) : kBounce) * kShare;
  if (dot(to_sun(), normal) < -kSunRadius) return light;
  const auto sun_free = scene.are_free(origin, round.sun[group]);
  for (std::size_t i = 0; i < kPerGroup; ++i) {
    if (sun_free[i] && dot(round.sun[group][i], normal) > 0) light.sun += kShare;
  }
  return light;
}

}  // namespace solitaire
