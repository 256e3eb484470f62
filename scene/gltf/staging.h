#pragma once
#include <tiny_gltf.h>

#include "scene/names.h"
#include "scene/scene.h"

namespace solitaire {

/// Adds a camera that holds the whole scene, a sun (KHR_lights_punctual) and a ground, as nodes beside the
/// scene's root. Viewers without a light of their own would show nothing.
void add_stage(tinygltf::Model& model, tinygltf::Scene& shown, const Scene& scene, UniqueNames& names);

}  // namespace solitaire
