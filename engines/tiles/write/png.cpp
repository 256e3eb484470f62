#include "engines/tiles/write/png.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <functional>
#include <map>
#include <png.h>
#include <stdexcept>

namespace solitaire::tiles {
namespace {

constexpr std::size_t kMostPixels = std::size_t{1} << 27U;

void append(png_structp png, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

/// What is known of a picture before its rows are: its size, and its colours where pixels are their numbers.
struct Header {
  int width, height;
  std::vector<Rgba> colors;  // at most kMostColors; none: pixels are colours
};

constexpr std::size_t kMostColors = 256;
/// Of zlib. The default takes more than three times as long for maps, for files that are a third smaller.
constexpr int kCompression = 3;

void write_colors(png_structp png, png_infop info, const std::vector<Rgba>& colors) {
  std::array<png_color, kMostColors> opaque{};
  std::array<png_byte, kMostColors> opacity{};
  for (std::size_t number = 0; number < colors.size(); ++number) {
    opaque.at(number) = {colors[number][0], colors[number][1], colors[number][2]};
    opacity.at(number) = colors[number][3];
  }
  const int count = static_cast<int>(colors.size());
  png_set_PLTE(png, info, opaque.data(), count);
  png_set_tRNS(png, info, opacity.data(), count, nullptr);
}

/// Encodes rows that are made one at a time, so that large maps take little memory. libpng leaves by longjmp
/// where it fails: nothing here has a destructor after setjmp.
bool encode(const Header& header, const void* row, const std::function<void(int)>& make_row,
            std::string& result) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(png, &result, append, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(header.width), static_cast<png_uint_32>(header.height), 8,
               header.colors.empty() ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!header.colors.empty()) write_colors(png, info, header.colors);
  png_set_compression_level(png, kCompression);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);  // tiles repeat themselves byte by byte
  png_write_info(png, info);
  for (int y = 0; y < header.height; ++y) {
    make_row(y);
    png_write_row(png, static_cast<png_const_bytep>(row));
  }
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  return true;
}

std::string encoded(const Header& header, const void* row, const std::function<void(int)>& make_row) {
  std::string result;
  if (!encode(header, row, make_row, result)) throw std::runtime_error("libpng failed");
  return result;
}

int icon_side(const Tileset& tileset, int side) {
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    const Picture& icon = tileset[static_cast<Tile>(tile)].icon;
    if (icon.width > 1) side = std::max(side, icon.width);
  }
  return side;
}

/// Returns the square of a tile: its icon, or a single pixel that stands for all.
Picture square_of(const TileKind& kind, int side) {
  if (kind.icon.width <= 1 || side == 1) return Picture(1, 1, kind.color);
  Picture square(side, side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) square.at(x, y) = kind.icon.at_share(x, side, y, side);
  }
  return square;
}

/// The squares of all tiles, and that of a hole behind them.
std::vector<Picture> squares_of(const Tileset& tileset, int side) {
  std::vector<Picture> squares;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile)
    squares.push_back(square_of(tileset[static_cast<Tile>(tile)], side));
  squares.emplace_back(1, 1, Rgba{});
  return squares;
}

/// The colours of some pictures, numbered; none if there are too many.
std::map<Rgba, std::uint8_t> few_colors(const std::vector<Picture>& pictures) {
  std::map<Rgba, std::uint8_t> numbers;
  for (const Picture& picture : pictures) {
    for (const Rgba& pixel : picture.pixels) {
      if (numbers.contains(pixel)) continue;
      if (numbers.size() == kMostColors) return {};
      numbers.emplace(pixel, static_cast<std::uint8_t>(numbers.size()));
    }
  }
  return numbers;
}

/// Draws a map row by row; Pixel is what the file has for one.
template <class Pixel>
class MapRows {
 public:
  MapRows(const Grid& map, int side, std::vector<std::vector<Pixel>> squares)
      : map_(map), side_(side), squares_(std::move(squares)), row_(row_length()) {}

  std::string encoded_with(std::vector<Rgba> colors) {
    const Header header{static_cast<int>(row_.size()), map_.size.height() * map_.size.depth() * side_,
                        std::move(colors)};
    return encoded(header, row_.data(), [this](int y) { draw(y); });
  }

 private:
  std::size_t row_length() const { return static_cast<std::size_t>(map_.size.width() * side_); }

  void draw(int y) {
    const int line = y / side_;
    auto to = row_.begin();
    for (int x = 0; x < map_.size.width(); ++x, to += side_) {
      const Tile tile = map_.at({x, line % map_.size.height(), line / map_.size.height()});
      const std::vector<Pixel>& square = tile == kHole ? squares_.back() : squares_[tile];
      if (square.size() == 1) {
        std::fill_n(to, side_, square.front());
      } else {
        std::copy_n(square.begin() + std::ptrdiff_t{y % side_} * side_, side_, to);
      }
    }
  }

  const Grid& map_;
  int side_;
  std::vector<std::vector<Pixel>> squares_;  // by tile, and that of a hole
  std::vector<Pixel> row_;
};

std::string draw_in_few_colors(const Grid& map, int side, const std::vector<Picture>& squares,
                               const std::map<Rgba, std::uint8_t>& numbers) {
  std::vector<Rgba> colors(numbers.size());
  for (const auto& [color, number] : numbers) colors[number] = color;
  std::vector<std::vector<std::uint8_t>> numbered;
  for (const Picture& square : squares) {
    numbered.emplace_back();
    for (const Rgba& pixel : square.pixels) numbered.back().push_back(numbers.at(pixel));
  }
  return MapRows<std::uint8_t>(map, side, std::move(numbered)).encoded_with(std::move(colors));
}

std::string draw_in_colors(const Grid& map, int side, std::vector<Picture> squares) {
  std::vector<std::vector<Rgba>> pixels;
  for (Picture& square : squares) pixels.push_back(std::move(square.pixels));
  return MapRows<Rgba>(map, side, std::move(pixels)).encoded_with({});
}

}  // namespace

std::string write_png(const Picture& picture) {
  std::vector<Rgba> row(static_cast<std::size_t>(picture.width));
  return encoded({picture.width, picture.height, {}}, row.data(), [&](int y) {
    for (int x = 0; x < picture.width; ++x) row[static_cast<std::size_t>(x)] = picture.at(x, y);
  });
}

std::string write_png(const Grid& map, const Tileset& tileset, int side) {
  side = icon_side(tileset, side);
  if (map.tiles.size() * static_cast<std::size_t>(side) * static_cast<std::size_t>(side) > kMostPixels)
    side = 1;
  std::vector<Picture> squares = squares_of(tileset, side);
  const std::map<Rgba, std::uint8_t> numbers = few_colors(squares);
  return numbers.empty() ? draw_in_colors(map, side, std::move(squares))
                         : draw_in_few_colors(map, side, squares, numbers);
}

}  // namespace solitaire::tiles
