#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// The bits of a gid that say how its tile is turned: along the diagonal first, then left to right, then top
/// to bottom. The lowest of the four bits turns tiles of hexagonal maps only, and is never kept.
inline constexpr std::uint32_t kFlipAcross = 0x80000000U;
inline constexpr std::uint32_t kFlipDown = 0x40000000U;
inline constexpr std::uint32_t kFlipDiagonal = 0x20000000U;
inline constexpr std::uint32_t kFlipHexagonal = 0x10000000U;
inline constexpr std::uint32_t kFlags = 0xf0000000U;

/// Returns what a tile's name has at its end for the flags: "!dh", or nothing.
std::string flag_letters(std::uint32_t gid);

/// Returns the name of a tile that consists of these parts: those of its layers from below, with + between
/// them and - where a layer has none.
std::string name_of_parts(std::vector<TiledPart> parts);

/// Finds the pixel of the tile that is seen at a place of its turned image, both in squares of that side.
void turn_place(std::uint32_t gid, int side, int& x, int& y);

/// Returns the gid of the same tile after a further quarter turn, clockwise.
std::uint32_t turned_gid(std::uint32_t gid);
/// Returns the gid of its mirror image, left to right.
std::uint32_t mirrored_gid(std::uint32_t gid);

}  // namespace solitaire::tiles
