#pragma once
#include <filesystem>
#include <string>

#include "scene/picture/image.h"

namespace solitaire {

/// Returns the image as the bytes of a PNG. Throws SceneError.
std::string png_bytes(const Image& image);

/// Reads a PNG, whatever its pixels are made of. Throws SceneError.
Image read_png(const std::filesystem::path& file);

}  // namespace solitaire
