#pragma once
#include "engines/tiles/rules/network_rule.h"

namespace solitaire::tiles {

/// No way over passable tiles leads back to where it came from: they form trees.
class Acyclic : public NetworkRule {
 public:
  using NetworkRule::NetworkRule;

  /// Returns how many links there are too many.
  std::uint64_t violation(const Grid& map) const override;
};

}  // namespace solitaire::tiles
