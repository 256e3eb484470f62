#include "engines/tiles/rules/tile_count.h"

namespace solitaire::tiles {

/// Counts what changes only.
class TileCount::Watch : public RuleWatch {
 public:
  Watch(const TileCount& rule, std::uint64_t count) : rule_(rule), count_(count), tried_(count) {}

  std::uint64_t after(const Grid& map, const Change& change) override {
    tried_ = count_;
    for (std::size_t i = 0; i < change.sites.size(); ++i) {
      tried_ += rule_.tiles_.contains(map[change.sites[i]]) ? 1 : 0;
      tried_ -= rule_.tiles_.contains(change.before[i]) ? 1 : 0;
    }
    return rule_.excess(tried_);
  }
  void keep() override { count_ = tried_; }

 private:
  const TileCount& rule_;
  std::uint64_t count_, tried_;
};

std::uint64_t TileCount::count(const Grid& map) const {
  std::uint64_t count = 0;
  for (const Tile tile : map.tiles) count += tiles_.contains(tile) ? 1 : 0;
  return count;
}

std::uint64_t TileCount::excess(std::uint64_t count) const {
  if (count < least_) return least_ - count;
  return count > most_ ? count - most_ : 0;
}

std::unique_ptr<RuleWatch> TileCount::watch(const Grid& map) const {
  return std::make_unique<Watch>(*this, count(map));
}

}  // namespace solitaire::tiles
