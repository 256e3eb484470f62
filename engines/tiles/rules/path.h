#pragma once
#include <string>
#include <vector>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// A path leads from one site to another. It steps from a tile to a neighbour where each is open towards the
/// other.
class Path : public GlobalRule {
 public:
  /// `open` has the open sides of each tile; 0 for those that are not passable.
  Path(const Topology& topology, std::vector<Sides> open, std::size_t from, std::size_t to, std::string text)
      : topology_(topology), open_(std::move(open)), from_(from), to_(to), text_(std::move(text)) {}

  /// Returns how many closed steps the best way between the sites takes; 0 if there is a path.
  std::uint64_t violation(const Grid& map) const override;
  std::string text() const override { return text_; }

 private:
  Topology topology_;
  std::vector<Sides> open_;
  std::size_t from_, to_;
  std::string text_;
};

}  // namespace solitaire::tiles
