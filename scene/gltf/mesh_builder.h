#pragma once
#include <cstdint>
#include <tiny_gltf.h>
#include <vector>

#include "scene/geometry.h"

namespace solitaire {

/// Collects triangles and writes them as one glTF primitive.
class MeshBuilder {
 public:
  /// Adds a flat face of three or more corners, counter-clockwise seen from outside, after applying `map`.
  void face(const std::vector<Vec3>& corners, const Affine& map = {});
  /// Adds a face of a rounded surface, which has a normal at each corner.
  void face(const std::vector<Vec3>& corners, const std::vector<Vec3>& normals);
  void add_box(const Box3& box, const Affine& map = {});

  Box3 box() const;  // of everything so far

  /// Returns the primitive after adding its accessors to the model, whose first buffer takes the data.
  tinygltf::Primitive write(tinygltf::Model& to) const;

 private:
  std::vector<float> positions_;
  std::vector<float> normals_;
  std::vector<std::uint16_t> indices_;
};

}  // namespace solitaire
