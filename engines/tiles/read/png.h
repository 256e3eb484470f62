#pragma once
#include <string>
#include <string_view>

#include "engines/tiles/model/picture.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Decodes a PNG file of at most 16 million pixels. Throws FileError.
Picture read_png(const std::string& name, std::string_view bytes);

/// Returns the mean of a picture's pixels; it has some.
Rgba mean_color(const Picture& picture);

/// Cuts a picture into squares of `side` pixels, a tile each; equal squares are equal tiles, and a
/// transparent one is a hole. With side 1 a tile is a colour. New tiles are added to an open tileset. Throws
/// FileError.
Grid cut_tiles(const std::string& name, const Picture& picture, int side, Tileset& tileset, bool open);

}  // namespace solitaire::tiles
