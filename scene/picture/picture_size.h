#pragma once
#include <cstddef>

namespace solitaire {

struct PictureSize {
  std::size_t width = 640, height = 480;  // pixels

  static constexpr std::size_t kMostPixels = 1U << 24;

  bool is_possible() const { return width > 0 && height > 0 && width <= kMostPixels / height; }
};

}  // namespace solitaire
