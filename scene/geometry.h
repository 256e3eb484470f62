#pragma once
#include <array>
#include <limits>

namespace solitaire {

using Vec3 = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  // x, y, z, w, as glTF writes it

/// A box along the axes. A new box is empty: the first point that is included becomes both of its corners.
struct Box3 {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  Vec3 low{kInfinity, kInfinity, kInfinity};
  Vec3 high{-kInfinity, -kInfinity, -kInfinity};

  void include(const Vec3& point);
  bool empty() const { return low[0] > high[0]; }
  Vec3 size() const { return {high[0] - low[0], high[1] - low[1], high[2] - low[2]}; }
  Vec3 corner(int index) const;  // 0..7; bit k chooses high over low on axis k
};

/// Scales, then rotates, then translates, as a glTF node does.
struct Transform {
  Vec3 translation{0, 0, 0};
  Quaternion rotation{0, 0, 0, 1};
  Vec3 scale{1, 1, 1};
};

/// An affine map: the upper three rows of a 4x4 matrix, by rows.
struct Affine {
  std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  Vec3 apply(const Vec3& point) const;
  bool is_identity() const { return rows == Affine{}.rows; }
};

Affine to_affine(const Transform& transform);
Affine operator*(const Affine& outer, const Affine& inner);
Box3 transformed(const Affine& map, const Box3& box);

/// Returns a turn about an axis, 0 to 2, as about_up does.
Quaternion about_axis(int axis, double degrees);

/// Returns the rotation that does `inner` first, rounded to 9 digits.
Quaternion after(const Quaternion& outer, const Quaternion& inner);
Quaternion reversed(const Quaternion& rotation);

/// Returns a turn about glTF's up axis, +Y, counter-clockwise seen from above. It is exact at quarter turns
/// and rounded to 9 digits elsewhere, so that processors whose sines differ in the last bit write the same
/// file.
Quaternion about_up(double degrees);

/// Returns the nearest multiple of 10^-digits, and 0 in place of -0.
double rounded(double value, int digits);

}  // namespace solitaire
