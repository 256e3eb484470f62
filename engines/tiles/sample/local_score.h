#pragma once
#include <vector>

#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// Scores the factors around single sites, for samplers that change one site at a time.
class LocalScore {
 public:
  /// A pair that may not be counts as a factor with this logarithm.
  LocalScore(const Problem& problem, double log_broken);

  /// Returns the sum of the logarithms of all factors that see the site.
  double at(const Grid& map, std::size_t site) const;
  /// Returns how many pairs of the site may not be.
  std::size_t broken_at(const Grid& map, std::size_t site) const;

 private:
  const Problem& problem_;
  double log_broken_;
  std::vector<std::vector<Point>> offsets_;  // of the shapes' sites
};

}  // namespace solitaire::tiles
