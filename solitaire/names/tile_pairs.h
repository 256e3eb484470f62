#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace solitaire {

/// Numbers of tiles in rows from the top.
using TileRows = std::vector<std::vector<std::uint32_t>>;
inline constexpr std::uint32_t kNoTile = UINT32_MAX;

/// Which tiles may be beside each other, as a program asks about it.
struct TilePairs {
  std::vector<std::string> names;
  std::vector<std::vector<std::uint32_t>> to_the_right;  // by tile: those that may be to its right
  std::vector<std::vector<std::uint32_t>> below;         // by tile: those that may be below it
  std::vector<TileRows> exemplars;                       // kNoTile for a hole
};

/// Knows the pairs of tiles that files tell: exemplars, and problem files of `solitaire tiles`. Several
/// threads may ask it at a time.
class TileFiles {
 public:
  virtual ~TileFiles() = default;

  /// Returns what the file tells, whose path is relative to the script. Throws a std::exception for a file
  /// that cannot be used.
  virtual std::shared_ptr<const TilePairs> find(const std::string& file) const = 0;
};

}  // namespace solitaire
