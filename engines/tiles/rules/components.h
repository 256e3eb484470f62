#pragma once
#include <cstdint>
#include <vector>

namespace solitaire::tiles {

/// Sets of sites that are joined step by step (union by path halving).
class Components {
 public:
  explicit Components(std::size_t sites) : parent_(sites) {
    for (std::uint32_t site = 0; site < sites; ++site) parent_[site] = site;
  }
  /// Returns true if the two were not joined before.
  bool join(std::size_t a, std::size_t b) {
    const std::uint32_t first = root(a), second = root(b);
    parent_[second] = first;
    return first != second;
  }

  /// Returns the number that all sites of a set have in common until it grows.
  std::uint32_t root(std::size_t of) {
    auto site = static_cast<std::uint32_t>(of);
    while (parent_[site] != site) site = parent_[site] = parent_[parent_[site]];
    return site;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace solitaire::tiles
