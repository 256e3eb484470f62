#pragma once

namespace solitaire {

inline constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

}  // namespace solitaire
