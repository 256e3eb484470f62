#pragma once
#include <memory>
#include <vector>

#include "engines/tile_maps/derived_choices.h"
#include "engines/tiles/model/problem.h"

namespace solitaire {

/// What a program asks of maps, as a rule about a map as a whole: how many of its conditions a map breaks,
/// when its other choices stay as they are. It remembers the last map that it saw, and looks at what differs.
class ProgramRule : public tiles::GlobalRule {
 public:
  /// `variables` are the choices of the sites, and `shown` has their values; a constant for a site that
  /// cannot change.
  ProgramRule(LiveConditions& conditions, const DerivedChoices& derived, std::vector<NodeId> variables,
              tiles::Grid shown)
      : conditions_(conditions),
        derived_(derived),
        variables_(std::move(variables)),
        shown_(std::move(shown)) {}

  std::uint64_t violation(const tiles::Grid& map) const override;
  std::string text() const override { return "the asserts of the program"; }

 private:
  LiveConditions& conditions_;
  const DerivedChoices& derived_;
  std::vector<NodeId> variables_;
  mutable tiles::Grid shown_;
};

/// Adds, for each site of a map, which tiles the conditions on that site alone leave it: what is pinned, or
/// asserted of a place. Other choices are not looked at.
void add_conditions_on_sites(const Graph& graph, LiveConditions& conditions,
                             const std::vector<NodeId>& variables, const tiles::Grid& map,
                             tiles::Problem& problem);

}  // namespace solitaire
