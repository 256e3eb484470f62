#include "scene/picture/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/picture/png.h"
#include "scene/picture/shading.h"

namespace solitaire {
namespace {

constexpr std::size_t kWidest = 320;  // pixels of a picture on the sheet
constexpr std::size_t kGap = 4;

/// The part of a row of source pixels that one target pixel covers, in 1/target of a source pixel, so that
/// all numbers are whole.
std::size_t overlap(std::size_t source, std::size_t target, std::size_t sources, std::size_t targets) {
  const std::size_t low = std::max(source * targets, target * sources);
  const std::size_t high = std::min((source + 1) * targets, (target + 1) * sources);
  return high > low ? high - low : 0;
}

void average(const Image& from, std::size_t x, std::size_t y, Image& to) {
  std::array<std::size_t, 3> sum{};
  for (std::size_t row = y * from.height / to.height; row < from.height; ++row) {
    const std::size_t tall = overlap(row, y, from.height, to.height);
    if (tall == 0) break;
    for (std::size_t column = x * from.width / to.width; column < from.width; ++column) {
      const std::size_t weight = tall * overlap(column, x, from.width, to.width);
      if (weight == 0) break;
      for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * from.pixel(column, row)[k];
    }
  }
  const std::size_t area = from.width * from.height;
  for (std::size_t k = 0; k < 3; ++k)
    to.pixel(x, y)[k] = static_cast<std::uint8_t>((sum[k] + area / 2) / area);
}

void paste(const Image& from, std::size_t x, std::size_t y, Image& to) {
  for (std::size_t row = 0; row < std::min(from.height, to.height - y); ++row) {
    const std::size_t bytes = 3 * std::min(from.width, to.width - x);
    std::copy_n(from.pixel(0, row), bytes, to.pixel(x, y + row));
  }
}

Image blank(std::size_t width, std::size_t height) {
  Image image(width, height);
  const Vector paper = background();
  for (std::size_t i = 0; i < width * height; ++i) {
    image.bytes[3 * i] = screen_byte(paper.x);
    image.bytes[3 * i + 1] = screen_byte(paper.y);
    image.bytes[3 * i + 2] = screen_byte(paper.z);
  }
  return image;
}

}  // namespace

Image scaled_down(const Image& image, std::size_t width) {
  if (image.width <= width) return image;
  Image scaled(width, std::max<std::size_t>(image.height * width / image.width, 1));
  for (std::size_t y = 0; y < scaled.height; ++y) {
    for (std::size_t x = 0; x < scaled.width; ++x) average(image, x, y, scaled);
  }
  return scaled;
}

Image contact_sheet(const std::vector<std::filesystem::path>& pictures) {
  const std::size_t number = std::min(pictures.size(), kMostOnSheet);
  if (number == 0) return blank(1, 1);
  Image first = scaled_down(read_png(pictures.front()), kWidest);
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(number))));
  const std::size_t rows = (number + columns - 1) / columns;
  Image sheet = blank(columns * (first.width + kGap) - kGap, rows * (first.height + kGap) - kGap);
  for (std::size_t i = 0; i < number; ++i) {
    const Image picture = i == 0 ? first : scaled_down(read_png(pictures[i]), kWidest);
    paste(picture, i % columns * (first.width + kGap), i / columns * (first.height + kGap), sheet);
  }
  return sheet;
}

}  // namespace solitaire
