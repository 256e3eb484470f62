#pragma once
#include "engines/tiles/rules/network_rule.h"

namespace solitaire::tiles {

/// All tiles that are passable form one network: every one of them can be reached from every other one. A map
/// without such tiles keeps the rule.
class Connected : public NetworkRule {
 public:
  using NetworkRule::NetworkRule;

  /// Returns how many components there are too many.
  std::uint64_t violation(const Grid& map) const override;
  std::unique_ptr<RuleWatch> watch(const Grid& map) const override;

 private:
  std::uint64_t networks(const Grid& map) const;
};

}  // namespace solitaire::tiles
