#pragma once
#include <filesystem>
#include <tiny_gltf.h>

namespace solitaire {

/// Reads a .glb or .gltf with the files that it refers to, which must lie in its own folder or below. Images
/// are kept as the PNG or JPEG bytes that they are. What is returned has passed check_model. Throws
/// SceneError.
tinygltf::Model read_gltf(const std::filesystem::path& file);

/// Reads a .glb as it is that write_glb may have written: its JSON is taken as it stands, and instances stay.
/// Throws as read_gltf does.
tinygltf::Model read_written_gltf(const std::filesystem::path& file);

}  // namespace solitaire
