#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace solitaire {

/// An image of 8-bit sRGB: rows from above, three bytes a pixel.
struct Image {
  std::size_t width = 0, height = 0;
  std::vector<std::uint8_t> bytes;

  Image() = default;
  Image(std::size_t w, std::size_t h) : width(w), height(h), bytes(3 * w * h) {}

  std::uint8_t* pixel(std::size_t x, std::size_t y) { return bytes.data() + 3 * (y * width + x); }
  const std::uint8_t* pixel(std::size_t x, std::size_t y) const { return bytes.data() + 3 * (y * width + x); }

  bool operator==(const Image&) const = default;
};

}  // namespace solitaire
