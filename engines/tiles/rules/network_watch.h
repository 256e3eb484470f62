#pragma once
#include <vector>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tileset.h"
#include "engines/tiles/rules/components.h"

namespace solitaire::tiles {

/// Returns how many networks there are too many where all is to be one.
inline std::uint64_t superfluous_networks(std::uint64_t networks) { return networks > 1 ? networks - 1 : 0; }

/// Follows how many networks the passable tiles of a map form. Around the sites that changed, it walks from
/// all sides at once, and only as far as it takes to know which sides are joined elsewhere, too: that is
/// never more than all but the largest of the networks that meet there.
class NetworkWatch : public RuleWatch {
 public:
  /// `open` has the open sides of each tile, `networks` says how many there are.
  NetworkWatch(const Topology& topology, const std::vector<Sides>& open, std::uint64_t networks);

  std::uint64_t after(const Grid& map, const Change& change) override;
  void keep() override { networks_ = tried_; }

 private:
  /// The sites that a walk has come to, in that order; those from `next` on have not been left yet.
  struct Walk {
    std::vector<std::uint32_t> sites;
    std::size_t next = 0;
    bool is_over() const { return next == sites.size(); }
  };

  void find_changed(const Grid& map, const Change& change);
  void find_doors(const Grid& map);
  void walk_outside(const Grid& map);
  void step(const Grid& map, std::size_t walk);
  bool is_known();
  std::uint64_t networks_here(const std::vector<Tile>& tiles, const Grid& map) const;
  void forget();

  bool is_changed(std::size_t site) const { return part_[site] != 0 && part_[site] <= changed_.size(); }

  const Topology& topology_;
  const std::vector<Sides>& open_;
  std::uint64_t networks_, tried_;
  /// By site: 0, or 1 + the number of what it belongs to: the sites that changed come first, then the walks.
  std::vector<std::uint32_t> part_;
  std::vector<std::uint32_t> changed_;
  std::vector<Tile> before_, now_;  // their tiles
  std::vector<Walk> walks_;         // each begins at a door: a site from which one comes to some that changed
  Components joined_{0};            // the numbers of walks that have met
};

}  // namespace solitaire::tiles
