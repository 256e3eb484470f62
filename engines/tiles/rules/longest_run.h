#pragma once
#include <string>
#include <vector>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tile_mask.h"

namespace solitaire::tiles {

/// Along an axis, at most so many tiles of a set follow each other. Runs end at borders, also where these are
/// periodic.
class LongestRun : public GlobalRule {
 public:
  LongestRun(const TileMask& tiles, std::vector<std::size_t> axes, std::uint64_t most, std::string text)
      : tiles_(tiles), axes_(std::move(axes)), most_(most), text_(std::move(text)) {}

  /// Returns how many tiles are in excess of what their runs may have.
  std::uint64_t violation(const Grid& map) const override;
  std::string text() const override { return text_; }

 private:
  TileMask tiles_;
  std::vector<std::size_t> axes_;
  std::uint64_t most_;
  std::string text_;
};

}  // namespace solitaire::tiles
