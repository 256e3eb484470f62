#pragma once
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// The factors of a map that a slice requires: all pairs, and those soft factors of known patches whose
/// random threshold lies above what an unknown patch is worth (product slice sampling). It knows which of
/// them a map does not meet, and keeps that up to date while the map changes.
class Slice {
 public:
  explicit Slice(const Problem& problem);

  /// Draws the thresholds for the map as it is. From now on soft factors that the slice requires must be met.
  void draw(const Grid& map, RandomStream& random);
  /// Looks at all factors of a map.
  void look_at(const Grid& map);
  /// Looks again at the factors that see some of these sites.
  void look_again(const Grid& map, const std::vector<std::uint32_t>& sites);

  std::size_t unmet() const { return unmet_.size(); }
  /// Returns how many of the required factors that see some of the sites are unmet.
  std::size_t unmet_around(const Grid& map, const std::vector<std::uint32_t>& sites);

  struct Scope {
    Point anchor;
    Size shape;
  };
  /// Returns where a random unmet factor is; there is one.
  Scope random_unmet(RandomStream& random) const;

 private:
  /// A kind of factor: a pair along an axis, or a soft shape.
  struct Kind {
    Size shape;
    std::size_t number;  // of the axis or of the soft shape
    bool is_pair;
    std::vector<Point> offsets;
  };

  bool is_met(const Grid& map, const Kind& kind, std::size_t anchor) const;
  bool is_known(const Grid& map, const Kind& kind, std::size_t anchor) const;
  bool is_whole(const Kind& kind, std::size_t anchor) const;
  void set_met(std::uint32_t factor, bool met);
  template <class Visit>
  void for_each_around(const std::vector<std::uint32_t>& sites, Visit visit);

  const Problem& problem_;
  std::vector<Kind> kinds_;
  std::vector<bool> required_;           // by factor: kind times sites, plus the anchor
  std::vector<std::uint32_t> unmet_;     // in no order
  std::vector<std::uint32_t> place_of_;  // by factor: its place in unmet_, plus 1; 0: it is met
  std::vector<std::uint32_t> seen_at_;   // by factor: the last visit that met it
  std::uint32_t visit_ = 0;
};

}  // namespace solitaire::tiles
