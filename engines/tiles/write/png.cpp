#include "engines/tiles/write/png.h"

#include <algorithm>
#include <csetjmp>
#include <functional>
#include <png.h>
#include <stdexcept>

namespace solitaire::tiles {
namespace {

constexpr std::size_t kMostPixels = std::size_t{1} << 27U;

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// Encodes rows that are made one at a time, so that large maps take little memory. libpng leaves by longjmp
/// where it fails: nothing here has a destructor after setjmp.
bool encode(int width, int height, Rgba* row, const std::function<void(int)>& make_row, std::string& result) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(png, &result, append, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
               PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);  // tiles repeat themselves byte by byte
  png_write_info(png, info);
  for (int y = 0; y < height; ++y) {
    make_row(y);
    png_write_row(png, reinterpret_cast<png_const_bytep>(row));
  }
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return true;
}

std::string encoded(int width, int height, std::vector<Rgba>& row, const std::function<void(int)>& make_row) {
  std::string result;
  if (!encode(width, height, row.data(), make_row, result)) throw std::runtime_error("libpng failed");
  return result;
}

int icon_side(const Tileset& tileset, int side) {
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const Picture& icon = tileset[static_cast<Tile>(tile)].icon;
    if (icon.width > 1) side = std::max(side, icon.width);
  }
  return side;
}

/// Returns the pixel of a tile at a place of its square.
Rgba pixel(const TileKind& kind, int x, int y, int side) {
  if (kind.icon.width <= 1 || side == 1) return kind.color;
  return kind.icon.at(x * kind.icon.width / side, y * kind.icon.height / side);
}

}  // namespace

std::string write_png(const Picture& picture) {
  std::vector<Rgba> row(static_cast<std::size_t>(picture.width));
  return encoded(picture.width, picture.height, row, [&](int y) {
    for (int x = 0; x < picture.width; ++x) row[static_cast<std::size_t>(x)] = picture.at(x, y);
  });
}

std::string write_png(const Grid& map, const Tileset& tileset, int side) {
  side = icon_side(tileset, side);
  if (map.tiles.size() * static_cast<std::size_t>(side) * static_cast<std::size_t>(side) > kMostPixels)
    side = 1;
  const int width = map.size.width() * side;
  std::vector<Rgba> row(static_cast<std::size_t>(width));
  return encoded(width, map.size.height() * map.size.depth() * side, row, [&](int y) {
    const int line = y / side;
    for (int x = 0; x < width; ++x) {
      const Tile tile = map.at({x / side, line % map.size.height(), line / map.size.height()});
      row[static_cast<std::size_t>(x)] =
          tile == kHole ? Rgba{} : pixel(tileset[tile], x % side, y % side, side);
    }
  });
}

}  // namespace solitaire::tiles
