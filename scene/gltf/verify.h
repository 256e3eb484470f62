#pragma once
#include <filesystem>

#include "scene/gltf/instances.h"
#include "scene/scene.h"

namespace solitaire {

/// Reads a written .glb back and checks that it holds this scene: indices in range, each name once, each
/// object under its parent and name with its address, filling its box to within rounding, and one set of
/// meshes for each asset and colour. Throws SceneError with what differs.
void verify_glb(const std::filesystem::path& file, const Scene& scene, Nodes nodes = Nodes::kOneEach);

}  // namespace solitaire
