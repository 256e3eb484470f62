#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scene/picture/ray_scene.h"

namespace solitaire {

/// The light that reaches a place.
struct Light {
  float sun = 0;   // the share of the sun that is seen from there, 0..1
  Vector ambient;  // what comes from the sky and from surfaces around, as the radiance of a white diffuse
                   // surface
};

/// The light of all pictures: a sun wide enough for soft shadows, a sky that is brighter above than around,
/// and what surfaces pass on of both.
///
/// Shadows are sampled. The directions of the samples are fixed and belong to kGroups groups; each group for
/// itself is spread over the whole sun and the whole sky. Neighbouring pixels ask for different groups and
/// share the results (interleaved sampling: Keller and Heidrich, 2001).
class Lighting {
 public:
  static constexpr std::size_t kGroups = 16;

  /// With more rounds, each group has so many times as many directions: pictures take longer, and show less
  /// of the pattern that few directions leave on surfaces which see little of the sky.
  explicit Lighting(std::size_t rounds = 1);

  /// Returns the light at a point on a surface, sampled with the directions of one group.
  Light sample(const RayScene& scene, const Vector& point, const Vector& normal, float lift,
               std::size_t group) const;

  /// Returns the light on open ground, on which nothing casts a shadow.
  Light in_the_open() const { return open_; }

  static Vector to_sun();
  static Vector sun_color();
  /// Returns the sky's radiance from a direction; below the horizon that of the ground.
  static Vector sky(const Vector& direction);

 private:
  static constexpr std::size_t kPerGroup = 4;
  using Directions = std::array<std::array<Vector, kPerGroup>, kGroups>;
  struct Round {
    Directions sky;  // around the y axis, as frequent as the cosine of their angle to it is large
    Directions sun;  // from points all over the sun
  };

  void add_round(std::uint64_t number);
  Light sample(const Round& round, const RayScene& scene, const Vector& origin, const Vector& normal,
               std::size_t group) const;

  std::vector<Round> rounds_;
  Light open_;
};

}  // namespace solitaire
