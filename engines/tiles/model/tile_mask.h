#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "engines/tiles/model/grid.h"

namespace solitaire::tiles {

/// A set of tiles.
class TileMask {
 public:
  constexpr TileMask() = default;
  /// Returns the set of the first `count` tiles.
  static TileMask first(std::size_t count) {
    TileMask mask;
    for (std::size_t tile = 0; tile < count; ++tile) mask.insert(static_cast<Tile>(tile));
    return mask;
  }
  static TileMask of(Tile tile) {
    TileMask mask;
    mask.insert(tile);
    return mask;
  }

  void insert(Tile tile) { words_[tile / 64U] |= bit(tile); }
  void erase(Tile tile) { words_[tile / 64U] &= ~bit(tile); }
  bool contains(Tile tile) const { return (words_[tile / 64U] & bit(tile)) != 0; }
  bool empty() const { return (words_[0] | words_[1] | words_[2] | words_[3]) == 0; }
  std::size_t size() const {
    std::size_t count = 0;
    for (const std::uint64_t word : words_) count += static_cast<std::size_t>(std::popcount(word));
    return count;
  }
  /// Returns the lowest tile of a set that is not empty.
  Tile lowest() const {
    std::size_t word = 0;
    while (words_[word] == 0) ++word;
    return static_cast<Tile>(64 * word + static_cast<std::size_t>(std::countr_zero(words_[word])));
  }

  /// Calls `visit(tile)` for each tile, in ascending order.
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::size_t word = 0; word < words_.size(); ++word) {
      for (std::uint64_t rest = words_[word]; rest != 0; rest &= rest - 1) {
        visit(static_cast<Tile>(64 * word + static_cast<std::size_t>(std::countr_zero(rest))));
      }
    }
  }

  /// Returns the tiles of this set that another one does not have.
  TileMask without(const TileMask& other) const {
    TileMask rest = *this;
    for (std::size_t word = 0; word < words_.size(); ++word) rest.words_[word] &= ~other.words_[word];
    return rest;
  }
  TileMask& operator&=(const TileMask& other) {
    for (std::size_t word = 0; word < words_.size(); ++word) words_[word] &= other.words_[word];
    return *this;
  }
  TileMask& operator|=(const TileMask& other) {
    for (std::size_t word = 0; word < words_.size(); ++word) words_[word] |= other.words_[word];
    return *this;
  }
  friend TileMask operator&(TileMask a, const TileMask& b) { return a &= b; }
  friend TileMask operator|(TileMask a, const TileMask& b) { return a |= b; }
  friend bool operator==(const TileMask&, const TileMask&) = default;

 private:
  static constexpr std::uint64_t bit(Tile tile) { return std::uint64_t{1} << (tile % 64U); }

  std::array<std::uint64_t, 4> words_{};
};

}  // namespace solitaire::tiles
