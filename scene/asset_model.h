#pragma once
#include <tiny_gltf.h>
#include <vector>

#include "scene/geometry.h"

namespace solitaire {

/// An asset's glTF after check_model: every index that can be reached from its roots is in range.
struct AssetModel {
  tinygltf::Model gltf;
  std::vector<int> roots;     // nodes of the scene that is shown
  int primary_material = -1;  // of the first primitive met from the roots: what a placement's color replaces

  /// One mesh at the origin and nothing else, as bundled assets are: placed nodes can carry the mesh
  /// themselves.
  bool is_single_mesh() const;
};

Affine local_transform(const tinygltf::Node& node);

}  // namespace solitaire
