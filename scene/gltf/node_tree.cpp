#include "scene/gltf/node_tree.h"

#include <algorithm>
#include <set>

namespace solitaire {
namespace {

/// glTF writes matrices column by column.
Affine from_matrix(const std::vector<double>& matrix) {
  Affine map;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) map.rows[row][column] = matrix[column * 4 + row];
  }
  return map;
}

}  // namespace

std::vector<int> root_nodes(const tinygltf::Model& model) {
  if (!model.scenes.empty())
    return model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
  std::set<int> children;
  for (const auto& node : model.nodes) children.insert(node.children.begin(), node.children.end());
  std::vector<int> roots;
  for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i) {
    if (!children.contains(i)) roots.push_back(i);
  }
  return roots;
}

Affine local_transform(const tinygltf::Node& node) {
  if (!node.matrix.empty()) return from_matrix(node.matrix);
  Transform transform;
  if (!node.translation.empty()) std::copy_n(node.translation.begin(), 3, transform.translation.begin());
  if (!node.rotation.empty()) std::copy_n(node.rotation.begin(), 4, transform.rotation.begin());
  if (!node.scale.empty()) std::copy_n(node.scale.begin(), 3, transform.scale.begin());
  return to_affine(transform);
}

}  // namespace solitaire
