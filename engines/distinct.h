#pragma once
#include <string>
#include <unordered_set>
#include <vector>

#include "engines/solution.h"

namespace solitaire {

/// Returns what each placed thing looks like, as text, sorted: its model, place, size, turn and colour.
std::vector<std::string> looks_of(const Solution& solution);

/// Tells solutions apart by what they look like: the value and the scene, and not the choices that led to
/// them. Which of several like objects is which does not count.
class DistinctResults {
 public:
  /// Returns true if no solution before looked like this one.
  bool add(const Solution& solution) { return seen_.insert(key(solution)).second; }

  static std::string key(const Solution& solution);

 private:
  std::unordered_set<std::string> seen_;
};

}  // namespace solitaire
