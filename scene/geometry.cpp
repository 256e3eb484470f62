#include "scene/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace solitaire {

void Box3::include(const Vec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], point[axis]);
    high[axis] = std::max(high[axis], point[axis]);
  }
}

Vec3 Box3::corner(int index) const {
  Vec3 point;
  for (int axis = 0; axis < 3; ++axis) point[axis] = (index >> axis) & 1 ? high[axis] : low[axis];
  return point;
}

Vec3 Affine::apply(const Vec3& point) const {
  Vec3 result;
  for (int i = 0; i < 3; ++i) {
    result[i] = rows[i][0] * point[0] + rows[i][1] * point[1] + rows[i][2] * point[2] + rows[i][3];
  }
  return result;
}

Affine to_affine(const Transform& transform) {
  const auto [x, y, z, w] = transform.rotation;
  const double rotation[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                                 {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                                 {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  Affine map;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) map.rows[i][j] = rotation[i][j] * transform.scale[j];
    map.rows[i][3] = transform.translation[i];
  }
  return map;
}

Affine operator*(const Affine& outer, const Affine& inner) {
  Affine product;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      product.rows[i][j] = j == 3 ? outer.rows[i][3] : 0;
      for (int k = 0; k < 3; ++k) product.rows[i][j] += outer.rows[i][k] * inner.rows[k][j];
    }
  }
  return product;
}

Box3 transformed(const Affine& map, const Box3& box) {
  Box3 result;
  for (int index = 0; index < 8; ++index) result.include(map.apply(box.corner(index)));
  return result;
}

Quaternion about_axis(int axis, double degrees) {
  const double half = std::remainder(degrees, 360.0) / 2 * std::numbers::pi / 180;
  Quaternion turn{0, 0, 0, rounded(std::cos(half), 9)};
  turn[static_cast<std::size_t>(axis)] = rounded(std::sin(half), 9);
  return turn;
}

Quaternion about_up(double degrees) { return about_axis(1, degrees); }

Quaternion after(const Quaternion& outer, const Quaternion& inner) {
  const auto [ax, ay, az, aw] = outer;
  const auto [bx, by, bz, bw] = inner;
  Quaternion product{aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
                     aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz};
  for (double& part : product) part = rounded(part, 9);
  return product;
}

Quaternion reversed(const Quaternion& rotation) {
  return {-rotation[0], -rotation[1], -rotation[2], rotation[3]};
}

double rounded(double value, int digits) {
  const double unit = std::pow(10.0, digits);
  return std::round(value * unit) / unit + 0.0;  // + 0.0 makes -0 into 0
}

}  // namespace solitaire
