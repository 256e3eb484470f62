#include "engines/tiles/read/text.h"

#include <fmt/format.h>
#include <map>
#include <stdexcept>

#include "base/file_error.h"
#include "engines/tiles/model/palette.h"

namespace solitaire::tiles {
namespace {

[[noreturn]] void fail(const std::string& name, std::size_t line, std::size_t column,
                       const std::string& reason) {
  throw FileError(fmt::format("{}:{}:{}", name, line, column), reason);
}

/// Returns how many bytes the character at the front has; 0 if it is no UTF-8.
std::size_t character_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xc2 ? 0
                             : lead < 0xe0 ? 2
                             : lead < 0xf0 ? 3
                             : lead < 0xf5 ? 4
                                           : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0U) != 0x80U) return 0;
  }
  return length;
}

/// Collects the rows of a map of characters.
class TextReader {
 public:
  TextReader(const std::string& name, Tileset& tileset, bool open)
      : name_(name), tileset_(tileset), open_(open) {
    for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
      by_text_.emplace(tileset[static_cast<Tile>(tile)].text, static_cast<Tile>(tile));
    }
  }

  Grid read(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
    if (text.empty()) fail(name_, 1, 1, "there is no map; write a row of characters a line");
    while (true) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      add_line(text.substr(0, end));
      if (end == text.size()) break;
      text.remove_prefix(end + 1);
    }
    end_layer();
    Grid grid;
    grid.size = {{static_cast<int>(width_), static_cast<int>(height_), static_cast<int>(depth_)}};
    grid.tiles = std::move(tiles_);
    return grid;
  }

 private:
  void add_line(std::string_view line) {
    ++line_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty()) {
      end_layer();
      return;
    }
    std::size_t column = 0;
    while (!line.empty()) {
      const std::size_t length = character_length(line);
      if (length == 0) fail(name_, line_, column + 1, "this is no UTF-8; save the file in that encoding");
      tiles_.push_back(tile(line.substr(0, length), ++column));
      line.remove_prefix(length);
    }
    if (tiles_.size() > kMostSites) fail(name_, line_, 1, fmt::format("more than {} sites", kMostSites));
    if (width_ == 0) width_ = column;
    if (column != width_) {
      fail(
          name_, line_, std::min(column, width_) + 1,
          fmt::format("this row has {} characters, the first has {}; make all rows as long", column, width_));
    }
    ++rows_;
  }

  void end_layer() {
    if (rows_ == 0) return;  // several empty lines are as one
    if (height_ == 0) height_ = rows_;
    if (rows_ != height_) {
      fail(name_, line_, 1,
           fmt::format("the layer that ends here has {} rows, the first has {}; an empty line begins a layer",
                       rows_, height_));
    }
    rows_ = 0;
    ++depth_;
  }

  Tile tile(std::string_view character, std::size_t column) {
    const std::string text(character);
    if (const auto known = by_text_.find(text); known != by_text_.end()) return known->second;
    if (!open_) fail(name_, line_, column, fmt::format("no tile has the character '{}'", text));
    TileKind kind;
    kind.name = kind.text = text;
    kind.color = palette_color(tileset_.size());
    try {
      return by_text_[text] = tileset_.add(std::move(kind));
    } catch (const std::length_error& error) {
      fail(name_, line_, column, error.what());
    }
  }

  const std::string& name_;
  Tileset& tileset_;
  bool open_;
  std::map<std::string, Tile> by_text_;
  std::vector<Tile> tiles_;
  std::size_t line_ = 0, rows_ = 0;  // rows of the layer so far
  std::size_t width_ = 0, height_ = 0, depth_ = 0;
};

}  // namespace

Grid read_text(const std::string& name, std::string_view text, Tileset& tileset, bool open) {
  return TextReader(name, tileset, open).read(text);
}

}  // namespace solitaire::tiles
