#pragma once
#include <tiny_gltf.h>
#include <vector>

#include "scene/geometry.h"

namespace solitaire {

/// Adds a mesh to the model that consists of copies of another one of its meshes, each moved, turned and
/// scaled as a transform says, and returns its number. Materials and all attributes of vertices are kept.
/// Throws SceneError for meshes of other things than triangles.
int merged_mesh(tinygltf::Model& model, int mesh, const std::vector<Transform>& transforms);

/// Removes the meshes that no node shows, such as those of which there are only merged copies.
void remove_unused_meshes(tinygltf::Model& model);

}  // namespace solitaire
