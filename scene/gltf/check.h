#pragma once
#include <tiny_gltf.h>

namespace solitaire {

/// tinygltf accepts dangling indices in silence. This refuses, with a SceneError that says what is wrong:
/// indices out of range anywhere that scene/ follows them, accessors that reach out of their buffers, vertex
/// indices without a vertex, numbers that are not finite, nodes that are no tree, and features that scene/
/// cannot copy.
void check_model(const tinygltf::Model& model);

}  // namespace solitaire
