#pragma once
#include <vector>

#include "engines/tile_maps/live_conditions.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// The auxiliary choices that a condition defines, as it does the distances of std/graph.sol: `x == e`. When
/// what they depend on changes, they follow: all begin at the ends of their ranges, and each takes the value
/// of its definition until all hold. Where values are the least that fulfil their definitions, which is so of
/// distances, they are found so (Bellman 1958); else the definitions stay broken.
class DerivedChoices {
 public:
  DerivedChoices(const Graph& graph, const Trace& trace, const LiveConditions& conditions);

  /// Evaluates what depends on changed choices, and lets the derived ones follow.
  void settle(LiveConditions& conditions) const;

 private:
  struct Definition {
    NodeId variable, value;
    std::int64_t lo, hi;  // of the variable
    std::size_t condition;
  };

  void begin_anew(LiveConditions& conditions) const;
  void follow(LiveConditions& conditions) const;
  bool any_defines(const std::vector<std::size_t>& conditions) const;

  std::vector<Definition> definitions_;
  std::vector<std::size_t> definition_of_;  // by condition: its definition, or SIZE_MAX
};

}  // namespace solitaire
