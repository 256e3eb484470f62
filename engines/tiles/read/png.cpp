#include "engines/tiles/read/png.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <png.h>
#include <stdexcept>

#include "base/file_error.h"

namespace solitaire::tiles {
namespace {

constexpr std::size_t kMostPixels = std::size_t{1} << 24U;

Picture square(const Picture& picture, int left, int top, int side) {
  Picture result(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) result.at(x, y) = picture.at(left + x, top + y);
  }
  return result;
}

bool is_transparent(const Picture& picture) {
  return std::ranges::all_of(picture.pixels, [](const Rgba& pixel) { return pixel[3] == 0; });
}

TileKind kind_of(const Picture& icon, std::size_t number) {
  TileKind kind;
  kind.color = mean_color(icon);
  kind.icon = icon;
  const Rgba& c = kind.color;
  kind.name =
      icon.width == 1 ? fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]) : fmt::format("tile{}", number);
  if (icon.width == 1 && c[3] != 255) kind.name += fmt::format("{:02x}", c[3]);
  return kind;
}

}  // namespace

Rgba mean_color(const Picture& picture) {
  std::array<std::uint64_t, 4> sum{};
  for (const Rgba& pixel : picture.pixels) {
    for (std::size_t channel = 0; channel < 4; ++channel) sum[channel] += pixel[channel];
  }
  Rgba mean{};
  for (std::size_t channel = 0; channel < 4; ++channel) {
    mean[channel] = static_cast<std::uint8_t>(sum[channel] / picture.pixels.size());
  }
  return mean;
}

Picture read_png(const std::string& name, std::string_view bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
    throw FileError(name, fmt::format("is no PNG file: {}", image.message));
  }
  if (std::size_t{image.width} * image.height > kMostPixels) {
    const std::string size = fmt::format("{} x {}", image.width, image.height);
    png_image_free(&image);
    throw FileError(name,
                    fmt::format("a picture of {} pixels is too large; {} are the most", size, kMostPixels));
  }
  image.format = PNG_FORMAT_RGBA;
  Picture picture(static_cast<int>(image.width), static_cast<int>(image.height));
  if (png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr) == 0) {
    throw FileError(name, fmt::format("is a broken PNG file: {}", image.message));
  }
  return picture;
}

Grid cut_tiles(const std::string& name, const Picture& picture, int side, Tileset& tileset, bool open) {
  if (picture.width % side != 0 || picture.height % side != 0) {
    throw FileError(name, fmt::format("a picture of {} x {} pixels cannot be cut into squares of {}",
                                      picture.width, picture.height, side));
  }
  std::map<std::vector<Rgba>, Tile> known;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    known.emplace(tileset[static_cast<Tile>(tile)].icon.pixels, static_cast<Tile>(tile));
  }
  Grid grid(Size{{picture.width / side, picture.height / side, 1}});
  for_each_point(grid.size, [&](const Point& at) {
    const Picture icon = square(picture, at[0] * side, at[1] * side, side);
    if (is_transparent(icon)) return;
    auto found = known.find(icon.pixels);
    if (found == known.end()) {
      if (!open)
        throw FileError(name, fmt::format("the square at ({},{}) is no tile of the tileset", at[0], at[1]));
      try {
        found = known.emplace(icon.pixels, tileset.add(kind_of(icon, tileset.size()))).first;
      } catch (const std::length_error& error) {
        throw FileError(name, fmt::format("{}; is a tile {} pixels wide? Say --tile N", error.what(), side));
      }
    }
    grid[grid.size.site(at)] = found->second;
  });
  return grid;
}

}  // namespace solitaire::tiles
