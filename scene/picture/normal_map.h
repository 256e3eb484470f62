#pragma once
#include <array>

#include "scene/picture/vector.h"

namespace solitaire {

/// Maps the normals of a surface whose points an affine map moves. It applies the matrix of cofactors, which
/// is right also where one axis is stretched more than another.
class NormalMap {
 public:
  explicit NormalMap(const Affine& map) {
    const auto& m = map.rows;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = m[(i + 1) % 3], &b = m[(i + 2) % 3];
      rows_[i] = to_vector({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
    }
  }

  /// Returns the mapped normal with length 1.
  Vector apply(const Vector& normal) const {
    return normalized({dot(rows_[0], normal), dot(rows_[1], normal), dot(rows_[2], normal)});
  }

 private:
  std::array<Vector, 3> rows_;
};

}  // namespace solitaire
