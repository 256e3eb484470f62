#pragma once
#include <span>
#include <string>
#include <tiny_gltf.h>

namespace solitaire {

/// Returns an image as the compressed bytes that its file holds. The image has passed check_model's look at
/// its buffer view.
std::span<const unsigned char> image_bytes(const tinygltf::Model& model, int image);

/// Returns "PNG", "JPEG", "WebP", "KTX2", or "of another kind": what the bytes begin like.
std::string image_kind(std::span<const unsigned char> bytes);

}  // namespace solitaire
