#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "engines/tiles/model/grid.h"

namespace solitaire::tiles {

/// Sites of a map that may have other tiles now, and those that they had.
struct Change {
  std::span<const std::uint32_t> sites;
  std::span<const Tile> before;
};

/// Follows how far a map is from keeping a rule, while few of its sites change at a time.
class RuleWatch {
 public:
  virtual ~RuleWatch() = default;
  /// Returns how far the map is from keeping the rule now. The change is forgotten unless it is kept.
  virtual std::uint64_t after(const Grid& map, const Change& change) = 0;
  /// From now on, changes are told from the map that the last one led to.
  virtual void keep() = 0;
};

/// A rule about a map as a whole, such as that its roads are one network.
class GlobalRule {
 public:
  virtual ~GlobalRule() = default;
  /// Returns how far the map is from keeping the rule: 0 if it does.
  virtual std::uint64_t violation(const Grid& map) const = 0;
  /// Returns what follows the map through changes. Rules that find out faster what a change does to a map
  /// than by looking at the whole of it have a watch of their own. The rule has to outlive it.
  virtual std::unique_ptr<RuleWatch> watch(const Grid& map) const;
  /// Returns the rule in words: "the tiles 'floor', 'door' are connected".
  virtual std::string text() const = 0;
};

}  // namespace solitaire::tiles
