#pragma once
#include <string>
#include <utility>
#include <vector>

#include "engines/tiles/rules/network_rule.h"

namespace solitaire::tiles {

/// A path leads over the network from one site to another.
class Path : public NetworkRule {
 public:
  Path(const Topology& topology, std::vector<Sides> open, std::size_t from, std::size_t to, std::string text)
      : NetworkRule(topology, std::move(open), std::move(text)), from_(from), to_(to) {}

  /// Returns how many closed steps the best way between the sites takes; 0 if there is a path.
  std::uint64_t violation(const Grid& map) const override;

 private:
  std::size_t from_, to_;
};

}  // namespace solitaire::tiles
