#pragma once
#include <filesystem>
#include <string>

#include "scene/gltf/instances.h"
#include "scene/scene.h"

namespace solitaire {

/// Returns the scene as the bytes of a .glb: glTF 2.0, metres, +Y up. Each asset's meshes are stored once for
/// each colour it has, and all its nodes share them; each placed node carries extras (see make_extras). The
/// same scene gives the same bytes.
std::string glb_bytes(const Scene& scene, Nodes nodes = Nodes::kOneEach);

/// Writes the .glb whole or not at all, after reading it back from disk and checking it with verify_glb.
/// Returns its bytes.
std::string write_glb(const Scene& scene, const std::filesystem::path& path, Nodes nodes = Nodes::kOneEach);

}  // namespace solitaire
