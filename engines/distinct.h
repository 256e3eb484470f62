#pragma once
#include <string>
#include <unordered_set>
#include <vector>

#include "solitaire/run/execution.h"

namespace solitaire {

/// What each placed thing looks like, as text, sorted: its model, place, size, turn and colour.
std::vector<std::string> looks_of(const Execution& execution);

/// Tells executions apart by what they look like: the value and the scene, and not the choices that led to
/// them. Which of several like objects is which does not count.
class DistinctResults {
 public:
  /// Whether no execution before looked like this one.
  bool add(const Execution& execution) { return seen_.insert(key(execution)).second; }

  static std::string key(const Execution& execution);

 private:
  std::unordered_set<std::string> seen_;
};

}  // namespace solitaire
