#pragma once
#include <cmath>

#include "scene/geometry.h"

namespace solitaire {

/// Three floats: a point, a direction or linear light, as the ray tracer computes with them.
struct Vector {
  float x = 0, y = 0, z = 0;
};

constexpr Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vector operator*(const Vector& a, const Vector& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr Vector operator*(const Vector& a, float s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vector& operator+=(Vector& a, const Vector& b) { return a = a + b; }

constexpr float dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr Vector mixed(const Vector& a, const Vector& b, float share_of_b) {
  return a * (1 - share_of_b) + b * share_of_b;
}

/// Returns the vector with length 1, or `otherwise` for one that has no direction.
inline Vector normalized(const Vector& v, const Vector& otherwise = {0, 1, 0}) {
  const float length = std::sqrt(dot(v, v));
  return length > 0 && std::isfinite(length) ? v * (1 / length) : otherwise;
}

inline Vector to_vector(const Vec3& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

}  // namespace solitaire
