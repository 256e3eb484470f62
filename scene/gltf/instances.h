#pragma once
#include <cstddef>
#include <string>
#include <tiny_gltf.h>
#include <vector>

#include "scene/scene.h"

namespace solitaire {

/// How the objects of a scene become nodes: one for each, or one for all that look alike and hang below one
/// node (EXT_mesh_gpu_instancing), with or without what would be the names and extras of their nodes. Or one
/// for all that look alike in a square of kChunk metres, whose mesh is put together from theirs: for
/// importers that know no instances.
enum class Nodes { kOneEach, kInstances, kPlainInstances, kChunks };
inline constexpr double kChunk = 32;

/// Returns the children of the node, as indices of Scene::nodes, put together as they share a node of the
/// file: each alone, or those of one mesh, of one square if they are merged. Parts come in the order of their
/// first members.
std::vector<std::vector<std::size_t>> parts_of(const Scene& scene, const SceneNode& node, Nodes nodes);

/// Makes the glTF node one of instances, a place in the scene for each of these nodes. Its extras have a
/// member "instances", unless these are plain: the JSON text of an array that holds, for each, what would be
/// its node's name and extras.
void make_instances(tinygltf::Model& model, tinygltf::Node& node, const Scene& scene,
                    const std::vector<std::size_t>& instances, Nodes nodes);

/// Returns where the instances of a node stand that make_instances has made.
std::vector<Transform> instance_transforms(const tinygltf::Model& model, const tinygltf::Node& node);

}  // namespace solitaire
