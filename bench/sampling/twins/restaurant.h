#pragma once
#include <array>
#include <vector>

#include "bench/sampling/twins/measure.h"

namespace twins {

/// The Chinese restaurant process by links, as std/process.sol has it, with alpha 1: a customer links to one
/// who came before or to itself, each alike.
class Restaurant {
 public:
  explicit Restaurant(std::size_t customers) : link_(customers), seat_(customers) {
    for (std::size_t i = 0; i < customers; ++i) link(i, i);
  }
  std::size_t customers() const { return link_.size(); }
  std::size_t link(std::size_t customer) const { return link_[customer]; }
  std::size_t seat(std::size_t customer) const { return seat_[customer]; }

  void link(std::size_t customer, std::size_t to) {
    link_[customer] = to;
    for (std::size_t i = customer; i < link_.size(); ++i) seat_[i] = link_[i] == i ? i : seat_[link_[i]];
  }

 private:
  std::vector<std::size_t> link_, seat_;
};

/// Weights above 0, whose shares have a Dirichlet distribution of ones.
template <std::size_t n>
struct SimplexWeights {
  SimplexWeights() { weights.fill(1); }
  double log_share(std::size_t which) const {
    double sum = 0;
    for (const double each : weights) sum += each;
    return std::log(weights[which] / sum);
  }
  double log_prior() const {
    double sum = 0;
    for (const double each : weights) sum -= each;
    return sum;
  }
  std::array<double, n> weights;
};

}  // namespace twins
