#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engines/tiles/rules/network_rule.h"

namespace solitaire::tiles {

/// Everything passable can be reached from a site, where a door is only walked through once a key of its kind
/// has been reached. So every door has its key before it. A key opens all doors of its kind.
class Keys : public NetworkRule {
 public:
  /// `keys` has, for each tile that is a door, the tile that is its key.
  Keys(const Topology& topology, std::vector<Sides> open, std::vector<std::optional<Tile>> keys,
       std::size_t from, std::string text)
      : NetworkRule(topology, std::move(open), std::move(text)), keys_(std::move(keys)), from_(from) {}

  /// Returns how many components of passable sites cannot be reached.
  std::uint64_t violation(const Grid& map) const override;

 private:
  std::vector<bool> reached(const Grid& map) const;
  std::uint64_t components_without(const Grid& map, const std::vector<bool>& reached) const;

  std::vector<std::optional<Tile>> keys_;
  std::size_t from_;
};

}  // namespace solitaire::tiles
