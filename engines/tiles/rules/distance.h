#pragma once
#include <string>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tile_mask.h"

namespace solitaire::tiles {

/// Any two tiles of a set are at least so many steps apart; a step goes to a neighbour. Rings of periodic
/// axes count as the shorter way.
class Distance : public GlobalRule {
 public:
  Distance(const Topology& topology, const TileMask& tiles, int least, std::string text)
      : topology_(topology), tiles_(tiles), least_(least), text_(std::move(text)) {}

  /// Returns how many pairs are too near.
  std::uint64_t violation(const Grid& map) const override;
  std::string text() const override { return text_; }

 private:
  Topology topology_;
  TileMask tiles_;
  int least_;
  std::string text_;
};

/// Any tile of a set is at least so many steps from any of another set; a tile of both is not compared with
/// itself.
class PairDistance : public GlobalRule {
 public:
  PairDistance(const Topology& topology, const TileMask& tiles, const TileMask& others, int least,
               std::string text)
      : topology_(topology), tiles_(tiles), others_(others), least_(least), text_(std::move(text)) {}

  /// Returns how many pairs are too near.
  std::uint64_t violation(const Grid& map) const override;
  std::string text() const override { return text_; }

 private:
  Topology topology_;
  TileMask tiles_, others_;
  int least_;
  std::string text_;
};

}  // namespace solitaire::tiles
