#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace solitaire::tiles {

/// Red, green, blue and opacity, 0 to 255, as in PNG files.
using Rgba = std::array<std::uint8_t, 4>;

/// Pixels in rows from the top. A picture without pixels is empty.
struct Picture {
  int width = 0, height = 0;
  std::vector<Rgba> pixels;

  Picture() = default;
  Picture(int w, int h, Rgba fill = {})
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
  bool empty() const { return pixels.empty(); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  const Rgba& at(int x, int y) const { return pixels[index(x, y)]; }
  /// Returns the pixel at a place of something of other extents, over which the picture is stretched.
  const Rgba& at_share(int x, int of_width, int y, int of_height) const {
    return at(static_cast<int>(std::int64_t{x} * width / of_width),
              static_cast<int>(std::int64_t{y} * height / of_height));
  }
  Rgba& at(int x, int y) { return pixels[index(x, y)]; }
  friend bool operator==(const Picture&, const Picture&) = default;
};

}  // namespace solitaire::tiles
