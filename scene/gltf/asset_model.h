#pragma once
#include <tiny_gltf.h>
#include <vector>

#include "scene/gltf/node_tree.h"

namespace solitaire {

/// An asset's glTF after check_model: every index that can be reached from its roots is in range.
struct AssetModel {
  tinygltf::Model gltf;
  std::vector<int> roots;     // the nodes at the top of the scene that is shown
  int primary_material = -1;  // the material whose colour a thing's colour replaces

  /// Returns true if the asset is one mesh at the origin and nothing else, as bundled assets are: then placed
  /// nodes can carry the mesh themselves.
  bool is_single_mesh() const;
};

/// Calls visit(mesh, map) for each mesh below the nodes, which is as deep as check_model allows. The map
/// leads from the mesh's frame to that of `outer`.
template <typename Visit>
void for_each_mesh(const AssetModel& model, const std::vector<int>& nodes, const Affine& outer,
                   const Visit& visit) {
  for (const int index : nodes) {
    const auto& node = model.gltf.nodes[static_cast<std::size_t>(index)];
    const Affine map = outer * local_transform(node);
    if (node.mesh != -1) visit(model.gltf.meshes[static_cast<std::size_t>(node.mesh)], map);
    for_each_mesh(model, node.children, map, visit);
  }
}

}  // namespace solitaire
