#pragma once
#include <string>
#include <vector>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// No way over passable tiles leads back to where it came from: they form trees. Two neighbours are linked if
/// each is open towards the other.
class Acyclic : public GlobalRule {
 public:
  /// `open` has the open sides of each tile; 0 for those that are not passable.
  Acyclic(const Topology& topology, std::vector<Sides> open, std::string text)
      : topology_(topology), open_(std::move(open)), text_(std::move(text)) {}

  /// Returns how many links there are too many.
  std::uint64_t violation(const Grid& map) const override;
  std::string text() const override { return text_; }

 private:
  Topology topology_;
  std::vector<Sides> open_;
  std::string text_;
};

}  // namespace solitaire::tiles
