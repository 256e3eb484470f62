#include "engines/tiles/tiled/tiled_map.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <zlib.h>
#include <zstd.h>

#include "base/file_error.h"
#include "engines/tiles/model/grid.h"

namespace solitaire::tiles {
namespace {

constexpr std::int64_t kMostExtent = 1 << 20;
constexpr std::size_t kMostLayers = 16;
constexpr double kSlack = 0.1;  // of a tile, by which a rectangle may be off

std::vector<std::uint32_t> decode_csv(const std::string& file, const std::string& text, std::size_t count) {
  std::vector<std::uint32_t> gids;
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto skip = [&] {
    at = std::find_if(at, end,
                      [](char c) { return c != ',' && c != '\n' && c != '\r' && c != ' ' && c != '\t'; });
  };
  for (skip(); at != end; skip()) {
    std::uint32_t gid = 0;
    const auto [stop, error] = std::from_chars(at, end, gid);
    if (error != std::errc{}) throw FileError(file, "a layer has data that are no numbers");
    if (gids.size() == count) throw FileError(file, "a layer has more tiles than its size says");
    gids.push_back(gid);
    at = stop;
  }
  return gids;
}

std::string decode_base64(const std::string& file, const std::string& text) {
  static constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char letter : text) {
    if (letter == '\n' || letter == '\r' || letter == ' ' || letter == '\t' || letter == '=') continue;
    const std::size_t value = kLetters.find(letter);
    if (value == std::string_view::npos) throw FileError(file, "a layer has data that are no base64");
    bits = bits << 6U | static_cast<unsigned>(value);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count));
  }
  return bytes;
}

[[noreturn]] void fail_packed(const std::string& file) {
  throw FileError(file, "a layer has packed data that are broken or of another size than it says");
}

/// Unpacks exactly so many bytes, and takes no more memory than they need.
std::string unpack_zstd(const std::string& file, const std::string& packed, std::size_t size) {
  std::string bytes(size, '\0');
  if (ZSTD_decompress(bytes.data(), size, packed.data(), packed.size()) != size) fail_packed(file);
  return bytes;
}

/// The same for zlib and gzip.
std::string inflate_bytes(const std::string& file, const std::string& packed, std::size_t size) {
  std::string bytes(size, '\0');
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 32) != Z_OK)
    throw FileError(file, "zlib failed");  // zlib's own form or gzip's
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int status = inflate(&stream, Z_FINISH);
  const bool whole = status == Z_STREAM_END && stream.avail_out == 0;
  inflateEnd(&stream);
  if (!whole) fail_packed(file);
  return bytes;
}

}  // namespace

std::vector<std::uint32_t> decode_gids(const std::string& file, const std::string& text,
                                       const std::string& encoding, const std::string& compression,
                                       std::size_t count) {
  if (count > kMostSites) throw FileError(file, fmt::format("a layer has more than {} tiles", kMostSites));
  std::vector<std::uint32_t> gids;
  if (encoding == "csv") {
    gids = decode_csv(file, text, count);
  } else if (encoding == "base64") {
    std::string bytes = decode_base64(file, text);
    if (compression == "zlib" || compression == "gzip") {
      bytes = inflate_bytes(file, bytes, 4 * count);
    } else if (compression == "zstd") {
      bytes = unpack_zstd(file, bytes, 4 * count);
    } else if (!compression.empty()) {
      throw FileError(
          file, fmt::format("the compression '{}' is not read; save the map with zlib or csv", compression));
    }
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
      std::uint32_t gid = 0;
      for (std::size_t byte = 0; byte < 4; ++byte) {
        gid |= std::uint32_t{static_cast<unsigned char>(bytes[at + byte])} << (8 * byte);
      }
      gids.push_back(gid);
    }
  } else {
    throw FileError(file,
                    fmt::format("the encoding '{}' is not read; save the map as csv or base64", encoding));
  }
  if (gids.size() != count) {
    throw FileError(file, fmt::format("a layer has {} tiles, but its size says {}", gids.size(), count));
  }
  return gids;
}

void TiledLayers::begin(const std::string& file) {
  if (++layers_ > kMostLayers)
    throw FileError(file, fmt::format("has more than {} visible layers; hide the others", kMostLayers));
}

void TiledLayers::add(const std::string& file, std::int64_t x, std::int64_t y, std::int64_t width,
                      std::int64_t height, const std::vector<std::uint32_t>& gids) {
  const bool fits = width > 0 && height > 0 && width <= kMostExtent && height <= kMostExtent &&
                    std::abs(x) <= kMostExtent && std::abs(y) <= kMostExtent &&
                    static_cast<std::size_t>(width * height) == gids.size();
  if (!fits) throw FileError(file, "a layer has a size or place that cannot be");
  chunks_.push_back({layers_ - 1, x, y, width, height, gids});
}

void TiledLayers::write_to(const std::string& file, TiledMap& map) const {
  if (chunks_.empty()) throw FileError(file, "has no tiles");
  std::int64_t left = kMostExtent, top = kMostExtent, right = -2 * kMostExtent, bottom = right;
  for (const Chunk& chunk : chunks_) {
    left = std::min(left, chunk.x);
    top = std::min(top, chunk.y);
    right = std::max(right, chunk.x + chunk.width);
    bottom = std::max(bottom, chunk.y + chunk.height);
  }
  const std::int64_t width = right - left, height = bottom - top;
  if (static_cast<std::size_t>(width) > kMostSites / static_cast<std::size_t>(height) / layers_) {
    throw FileError(file, fmt::format("a map of {} x {} tiles is too large", width, height));
  }
  map.width = static_cast<int>(width);
  map.height = static_cast<int>(height);
  map.layers.assign(layers_, std::vector<std::uint32_t>(static_cast<std::size_t>(width * height)));
  for (const Chunk& chunk : chunks_) {
    for (std::int64_t y = 0; y < chunk.height; ++y) {
      const auto from = chunk.gids.begin() + y * chunk.width;
      std::copy(from, from + chunk.width,
                map.layers[chunk.layer].begin() + (chunk.y - top + y) * width + chunk.x - left);
    }
  }
}

double checked_weight(const std::string& file, double weight) {
  if (!(weight >= 1e-6 && weight <= 1e6))
    throw FileError(file, fmt::format("a tile has the weight {}; from 0.000001 to 1000000 are read", weight));
  return weight;
}

TiledPin pin_of(const std::string& file, const TiledObject& object, int tile_width, int tile_height) {
  const auto fail = [&](const std::string& reason) {
    throw FileError(file, fmt::format("the pin '{}' {}", object.name, reason));
  };
  if (tile_width < 1 || tile_height < 1) fail("is in a map that does not say how large its tiles are");
  const double from[] = {object.x / tile_width, object.y / tile_height};
  const double extent[] = {object.width / tile_width, object.height / tile_height};
  TiledPin pin;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double to = from[axis] + extent[axis];
    if (!(from[axis] >= 0 && extent[axis] >= 0 && to <= static_cast<double>(kMostExtent)))
      fail("is at a place that cannot be");
    // Rectangles drawn by hand are a little off. A point is a pin of the site that it is in.
    pin.from.at(axis) = static_cast<int>(std::floor(from[axis] + kSlack));
    pin.to.at(axis) = std::max(pin.from.at(axis) + 1, static_cast<int>(std::ceil(to - kSlack)));
  }
  for (std::size_t begin = 0; begin <= object.name.size();) {
    const std::size_t end = std::min(object.name.find('|', begin), object.name.size());
    pin.tiles.push_back(object.name.substr(begin, end - begin));
    begin = end + 1;
  }
  return pin;
}

WangColors wang_colors(const std::string& file, const std::vector<std::int64_t>& ids,
                       const std::vector<std::string>& colors) {
  WangColors result;
  if (ids.size() != result.size()) throw FileError(file, "a Wang set has a tile without its eight colours");
  for (std::size_t place = 0; place < ids.size(); ++place) {
    if (ids[place] < 0 || ids[place] > static_cast<std::int64_t>(colors.size()))
      throw FileError(file, fmt::format("a Wang set has no colour {}", ids[place]));
    if (ids[place] > 0) result.at(place) = colors[static_cast<std::size_t>(ids[place] - 1)];
  }
  return result;
}

std::filesystem::path file_beside(const std::filesystem::path& map, const std::string& named) {
  const std::filesystem::path relative = std::filesystem::path(named).lexically_normal();
  if (relative.empty() || relative.is_absolute() || *relative.begin() == "..") {
    throw FileError(map.string(),
                    fmt::format("names the file '{}', which is not in the map's folder", named));
  }
  return map.parent_path() / relative;
}

}  // namespace solitaire::tiles
