#pragma once
#include <cstddef>
#include <string>
#include <tiny_gltf.h>
#include <vector>

#include "scene/scene.h"

namespace solitaire {

/// How the objects of a scene become nodes: one for each, or one for all that look alike and hang below one
/// node (EXT_mesh_gpu_instancing).
enum class Nodes { kOneEach, kInstances };

/// Returns the children of the node, as indices of Scene::nodes, put together as they share a node of the
/// file: each alone, or those of one mesh. Parts come in the order of their first members.
std::vector<std::vector<std::size_t>> parts_of(const Scene& scene, const SceneNode& node, Nodes nodes);

/// Makes the glTF node one of instances, a place in the scene for each of these nodes. Its extras have a
/// member "instances": the JSON text of an array that holds, for each, what would be its node's name and
/// extras.
void make_instances(tinygltf::Model& model, tinygltf::Node& node, const Scene& scene,
                    const std::vector<std::size_t>& instances);

/// Returns where the instances of a node stand that make_instances has made.
std::vector<Transform> instance_transforms(const tinygltf::Model& model, const tinygltf::Node& node);

}  // namespace solitaire
