#pragma once
#include <cmath>
#include <map>
#include <string>

#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// All maps of a small problem that keep all rules, with their probabilities. Found by trying all tiles at
/// all sites, by the definition of the distribution and without any code of the samplers.
class Enumeration {
 public:
  explicit Enumeration(const Problem& problem);

  std::size_t size() const { return probability_.size(); }
  const std::map<std::string, double>& probability() const { return probability_; }

  /// Counts draws, for a test of them against the probabilities.
  void draw(const Grid& map);
  /// Returns Pearson's chi squared over its degrees of freedom. Maps that are expected fewer than five times
  /// are taken together.
  double chi_squared() const { return fit().chi_squared / static_cast<double>(fit().degrees); }
  /// Returns how many standard deviations Pearson's chi squared is above what is expected of draws from the
  /// distribution: its cube root is nearly normal (Wilson and Hilferty 1931).
  double deviations() const;
  /// Returns how many standard deviations of independent draws the mean logarithm of their probabilities is
  /// from its expectation. A wrong weight shows here first: all maps together measure it.
  double score_deviations() const;
  /// Returns the logarithm of the probability of one of the maps.
  double score(const Grid& map) const { return std::log(probability_.at(key(map))); }
  /// Returns how many draws were no map of the problem.
  std::size_t strangers() const { return strangers_; }

 private:
  struct Fit {
    double chi_squared = 0;
    std::size_t degrees = 0;  // of freedom
  };

  static std::string key(const Grid& map) { return {map.tiles.begin(), map.tiles.end()}; }
  Fit fit() const;
  void extend(Grid& map, std::size_t site);
  double log_weight(const Grid& map) const;

  const Problem& problem_;
  std::map<std::string, double> probability_;  // by the bytes of the tiles
  std::map<std::string, std::size_t> drawn_;
  std::size_t draws_ = 0, strangers_ = 0;
};

}  // namespace solitaire::tiles
