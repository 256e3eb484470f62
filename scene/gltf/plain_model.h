#pragma once
#include <tiny_gltf.h>

namespace solitaire {

/// Rewrites what glTF has more compact forms for, so that nothing behind has to know them: sparse accessors
/// and quantized attributes become plain ones of floats (KHR_mesh_quantization), and instances nodes of their
/// own (EXT_mesh_gpu_instancing). To be called before check_model. Throws SceneError for data that reaches
/// out of its buffer.
void make_plain(tinygltf::Model& model);

}  // namespace solitaire
