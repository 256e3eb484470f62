#include "engines/tiles/write/text.h"

#include <set>
#include <string_view>
#include <vector>

namespace solitaire::tiles {
namespace {

std::string utf8(unsigned code) {
  if (code < 0x80) return {static_cast<char>(code)};
  return {static_cast<char>(0xc0U | code >> 6U), static_cast<char>(0x80U | (code & 0x3fU))};
}

std::vector<std::string> characters(const Tileset& tileset) {
  std::vector<std::string> result;
  std::set<std::string> taken;
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    result.push_back(tileset[static_cast<Tile>(tile)].text);
    taken.insert(result.back());
  }
  static constexpr std::string_view kFirst = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  std::size_t next = 0;
  for (std::string& text : result) {
    while (text.empty() || (taken.contains(text) && text.empty())) {
      // Beyond the letters and digits come the letters of U+0100 and so on.
      const std::string candidate = next < kFirst.size()
                                        ? std::string(1, kFirst[next])
                                        : utf8(0x100 + static_cast<unsigned>(next - kFirst.size()));
      ++next;
      if (taken.insert(candidate).second) text = candidate;
    }
  }
  return result;
}

}  // namespace

std::string write_text(const Grid& map, const Tileset& tileset) {
  const std::vector<std::string> text = characters(tileset);
  std::string result;
  for_each_point(map.size, [&](const Point& at) {
    if (at[0] == 0 && at[1] == 0 && at[2] > 0) result += '\n';
    const Tile tile = map.at(at);
    result += tile == kHole ? " " : text[tile];
    if (at[0] == map.size.width() - 1) result += '\n';
  });
  return result;
}

}  // namespace solitaire::tiles
