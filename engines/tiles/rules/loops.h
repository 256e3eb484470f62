#pragma once
#include "engines/tiles/rules/network_rule.h"

namespace solitaire::tiles {

/// Wherever one comes to over passable tiles, two ways lead there that have neither a tile nor a step in
/// common: no network falls apart without one of its sites or links. Networks of a single site keep the rule.
class Loops : public NetworkRule {
 public:
  using NetworkRule::NetworkRule;

  /// Returns how many sites and links there are without which a network falls apart.
  std::uint64_t violation(const Grid& map) const override;
};

}  // namespace solitaire::tiles
