#pragma once
#include <tiny_gltf.h>
#include <vector>

#include "scene/geometry.h"

namespace solitaire {

/// Returns the nodes at the top of what the model shows: those of its default scene, of its first scene where
/// none is the default, or all nodes without a parent in a file without scenes.
std::vector<int> root_nodes(const tinygltf::Model& model);

/// Returns the map from the node's own frame to its parent's.
Affine local_transform(const tinygltf::Node& node);

}  // namespace solitaire
