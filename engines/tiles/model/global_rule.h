#pragma once
#include <cstdint>
#include <string>

#include "engines/tiles/model/grid.h"

namespace solitaire::tiles {

/// A rule about a map as a whole, such as that its roads are one network.
class GlobalRule {
 public:
  virtual ~GlobalRule() = default;
  /// Returns how far the map is from keeping the rule: 0 if it does.
  virtual std::uint64_t violation(const Grid& map) const = 0;
  /// Returns the rule in words: "the tiles 'floor', 'door' are connected".
  virtual std::string text() const = 0;
};

}  // namespace solitaire::tiles
