#include "scene/gltf/asset_model.h"

namespace solitaire {

bool AssetModel::is_single_mesh() const {
  if (roots.size() != 1) return false;
  const auto& node = gltf.nodes[static_cast<std::size_t>(roots.front())];
  return node.mesh != -1 && node.children.empty() && local_transform(node).is_identity();
}

}  // namespace solitaire
