#include "engines/tiles/tiled/gid_flags.h"

#include <array>
#include <utility>

namespace solitaire::tiles {
namespace {

constexpr int kSide = 3;  // of a square whose places tell all orientations apart

using Places = std::array<std::array<int, 2>, kSide * kSide>;

/// Returns where each place of the square comes from; `seen` says which place of the turned image to look at.
template <class Seen>
Places sources(std::uint32_t gid, Seen seen) {
  Places places{};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      auto [from_x, from_y] = seen(x, y);
      turn_place(gid, kSide, from_x, from_y);
      places.at(static_cast<std::size_t>(kSide * y + x)) = {from_x, from_y};
    }
  }
  return places;
}

/// Returns the gid whose image has at each place what `seen` says of the image of another gid.
template <class Seen>
std::uint32_t gid_that_shows(std::uint32_t gid, Seen seen) {
  const Places wanted = sources(gid, seen);
  const std::uint32_t plain = gid & ~kFlags;
  for (std::uint32_t flags = 0; flags < 8; ++flags) {
    const std::uint32_t turned = plain | flags << 29U;
    if (sources(turned, [](int x, int y) { return std::pair{x, y}; }) == wanted) return turned;
  }
  return gid;  // never: the eight orientations are all that there are
}

}  // namespace

std::string flag_letters(std::uint32_t gid) {
  std::string letters;
  if ((gid & kFlipDiagonal) != 0) letters += 'd';
  if ((gid & kFlipAcross) != 0) letters += 'h';
  if ((gid & kFlipDown) != 0) letters += 'v';
  return letters.empty() ? "" : "!" + letters;
}

std::string name_of_parts(std::vector<TiledPart> parts) {
  while (parts.size() > 1 && parts.back().gid == 0) parts.pop_back();
  std::string name;
  for (const TiledPart& part : parts) {
    if (&part != &parts.front()) name += '+';
    name += part.gid == 0 ? "-" : part.name + flag_letters(part.gid);
  }
  return name;
}

void turn_place(std::uint32_t gid, int side, int& x, int& y) {
  if ((gid & kFlipAcross) != 0) x = side - 1 - x;
  if ((gid & kFlipDown) != 0) y = side - 1 - y;
  if ((gid & kFlipDiagonal) != 0) std::swap(x, y);
}

std::uint32_t turned_gid(std::uint32_t gid) {
  return gid_that_shows(gid, [](int x, int y) { return std::pair{y, kSide - 1 - x}; });
}

std::uint32_t mirrored_gid(std::uint32_t gid) {
  return gid_that_shows(gid, [](int x, int y) { return std::pair{kSide - 1 - x, y}; });
}

}  // namespace solitaire::tiles
