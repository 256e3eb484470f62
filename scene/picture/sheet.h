#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "scene/picture/image.h"

namespace solitaire {

/// How many pictures a contact sheet shows at most.
constexpr std::size_t kMostOnSheet = 100;

/// Returns the image scaled down to this width, in proportion. Each pixel is the mean of what it covers. An
/// image that is not wider is returned as it is.
Image scaled_down(const Image& image, std::size_t width);

/// Returns one image of the first kMostOnSheet of these PNG files, which are all of one size: scaled down,
/// and in rows from the upper left. Throws SceneError.
Image contact_sheet(const std::vector<std::filesystem::path>& pictures);

}  // namespace solitaire
