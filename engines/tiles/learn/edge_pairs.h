#pragma once
#include <string>

#include "engines/tiles/model/pair_rules.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Returns whether two sides with these labels may touch. Labels are read clockwise around their tile, so
/// that what is "a|b" here is "b|a" over there; a label without | is the same from both sides. No label meets
/// none.
bool labels_meet(const std::string& one, const std::string& other);

/// Allows all pairs of tiles whose sides have labels that meet.
void allow_labelled_pairs(const Tileset& tileset, PairRules& rules);

}  // namespace solitaire::tiles
