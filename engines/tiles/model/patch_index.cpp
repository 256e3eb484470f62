#include "engines/tiles/model/patch_index.h"

#include <bit>
#include <stdexcept>

#include "base/hash.h"

namespace solitaire::tiles {
namespace {

/// A table by code takes at most 4 bytes times two to this power.
constexpr std::size_t kDenseBits = 20;

}  // namespace

PatchIndex::PatchIndex(Size shape, std::size_t tiles) : shape_(shape), bits_(bits_for(tiles)), codes_(1) {
  if (shape.volume() > most_sites(tiles)) throw std::length_error("a shape has too many sites");
  if (shape.volume() * bits_ <= kDenseBits) dense_.resize(std::size_t{1} << (shape.volume() * bits_));
}

unsigned PatchIndex::bits_for(std::size_t tiles) {
  return tiles < 2 ? 1U : static_cast<unsigned>(std::bit_width(tiles - 1));
}

std::uint32_t PatchIndex::insert(PatchCode code) {
  std::uint32_t& number = dense_.empty() ? numbers_[code] : dense_[static_cast<std::size_t>(code)];
  if (number == 0) {
    number = static_cast<std::uint32_t>(codes_.size());
    codes_.push_back(code);
  }
  return number;
}

std::size_t PatchIndex::Hash::operator()(PatchCode code) const {
  return mix(static_cast<std::uint64_t>(code), static_cast<std::uint64_t>(code >> 64U));
}

}  // namespace solitaire::tiles
