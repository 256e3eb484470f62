#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Everything passable can be reached from a site, where a door is only walked through once a key of its kind
/// has been reached. So every door has its key before it. A key opens all doors of its kind.
class Keys : public GlobalRule {
 public:
  /// `open` has the open sides of each tile, 0 for those that are not passable; `keys` has, for each tile
  /// that is a door, the tile that is its key.
  Keys(const Topology& topology, std::vector<Sides> open, std::vector<std::optional<Tile>> keys,
       std::size_t from, std::string text)
      : topology_(topology),
        open_(std::move(open)),
        keys_(std::move(keys)),
        from_(from),
        text_(std::move(text)) {}

  /// Returns how many components of passable sites cannot be reached.
  std::uint64_t violation(const Grid& map) const override;
  std::string text() const override { return text_; }

 private:
  std::vector<bool> reached(const Grid& map) const;
  std::uint64_t components_without(const Grid& map, const std::vector<bool>& reached) const;
  template <class Visit>
  void for_each_linked(const Grid& map, std::size_t site, Visit visit) const;

  Topology topology_;
  std::vector<Sides> open_;
  std::vector<std::optional<Tile>> keys_;
  std::size_t from_;
  std::string text_;
};

}  // namespace solitaire::tiles
