#pragma once
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engines/tiles/model/grid.h"

namespace solitaire::tiles {

/// The tiles of a patch in the order of their sites, packed with the same number of bits each.
__extension__ using PatchCode = unsigned __int128;

/// Numbers the different patches of one shape, from 1 on. Number 0 means that a patch is not known. Patches
/// are compared as a whole and never by a hash alone.
class PatchIndex {
 public:
  /// A shape has at most as many sites as fit a code: 16, or 25 where there are 32 tiles or fewer.
  PatchIndex(Size shape, std::size_t tiles);
  static std::size_t most_sites(std::size_t tiles) { return 128 / bits_for(tiles); }
  /// Returns how many bits a tile takes.
  static unsigned bits_for(std::size_t tiles);

  const Size& shape() const { return shape_; }
  unsigned bits() const { return bits_; }
  /// Returns the number of different patches.
  std::size_t size() const { return codes_.size() - 1; }
  PatchCode code(std::size_t number) const { return codes_[number]; }
  Tile tile(PatchCode code, std::size_t place) const {
    return static_cast<Tile>((code >> (place * bits_)) & ((1U << bits_) - 1));
  }

  /// Returns the numbers by code where codes are short enough for a table of all of them; else null.
  const std::uint32_t* table() const { return dense_.empty() ? nullptr : dense_.data(); }

  /// Returns the patch's number, a new one if it was not known.
  std::uint32_t insert(PatchCode code);
  /// Returns the patch's number, or 0.
  std::uint32_t find(PatchCode code) const {
    if (!dense_.empty()) return dense_[static_cast<std::size_t>(code)];
    const auto found = numbers_.find(code);
    return found == numbers_.end() ? 0 : found->second;
  }

 private:
  struct Hash {
    std::size_t operator()(PatchCode code) const;
  };

  Size shape_;
  unsigned bits_;
  std::vector<std::uint32_t> dense_;  // by code, where codes are short; else empty
  std::unordered_map<PatchCode, std::uint32_t, Hash> numbers_;
  std::vector<PatchCode> codes_;  // by number
};

}  // namespace solitaire::tiles
