#pragma once
#include <cstdint>

#include "base/hash.h"

namespace solitaire {

/// What a stream of random numbers is for. Streams of different purposes never meet.
enum class Purpose : std::uint64_t {
  kExplore = 1,
  kSolver = 2,
  kSuggest = 3,
  kCells = 4,
  kSample = 5,
  kCount = 6,
  kPicture = 7,
  kTiles = 8,
  kNearby = 9,
  kSigns = 10,
  kChain = 11
};

/// A counter-based stream keyed by (seed, purpose, index): its numbers depend on nothing else, on any
/// machine.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, Purpose purpose, std::uint64_t index)
      : key_(mix(mix(seed, static_cast<std::uint64_t>(purpose)), index)) {}

  std::uint64_t next() { return mix(key_, counter_++); }
  /// Uniform over 0 .. bound - 1; bound is not 0.
  std::uint64_t below(std::uint64_t bound) {
    std::uint64_t number = next();
    // 2^64 mod bound numbers are too many, the smallest ones; a division tells how many, where it matters.
    while (number < bound && number < (UINT64_MAX - bound + 1) % bound) number = next();
    return number % bound;
  }

  /// Uniform over 0 .. bound - 1, too, from half a number and mostly without a division (Lemire, "Fast random
  /// integer generation in an interval", 2019): for what a chain draws at every step.
  std::uint64_t pick(std::uint32_t bound) {
    std::uint64_t product = (next() >> 32) * bound;
    // 2^32 mod bound halves are too many, and a product that ends below that is one of them.
    while (static_cast<std::uint32_t>(product) < bound &&
           static_cast<std::uint32_t>(product) < (UINT32_MAX - bound + 1) % bound)
      product = (next() >> 32) * bound;
    return product >> 32;
  }

  /// Uniform over the 2^53 - 1 multiples of 2^-53 strictly between 0 and 1.
  double uniform() { return static_cast<double>(1 + below((std::uint64_t{1} << 53) - 1)) * 0x1p-53; }

 private:
  std::uint64_t key_;
  std::uint64_t counter_ = 0;
};

}  // namespace solitaire
