#pragma once
#include <string>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tile_mask.h"

namespace solitaire::tiles {

/// A map has at least and at most so many tiles of a set.
class TileCount : public GlobalRule {
 public:
  TileCount(const TileMask& tiles, std::uint64_t least, std::uint64_t most, std::string text)
      : tiles_(tiles), least_(least), most_(most), text_(std::move(text)) {}

  /// Returns how many there are too few or too many.
  std::uint64_t violation(const Grid& map) const override { return excess(count(map)); }
  std::unique_ptr<RuleWatch> watch(const Grid& map) const override;
  std::string text() const override { return text_; }

 private:
  class Watch;
  std::uint64_t count(const Grid& map) const;
  std::uint64_t excess(std::uint64_t count) const;

  TileMask tiles_;
  std::uint64_t least_, most_;
  std::string text_;
};

}  // namespace solitaire::tiles
