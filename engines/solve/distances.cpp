#include "engines/solve/distances.h"

#include <utility>

#include "engines/errors.h"
#include "engines/solve/executions/auxiliary.h"

namespace solitaire {

void Distances::keep_away_from(Valuation solution) {
  if (bound_.any()) kept_.push_back({std::move(solution)});
}

bool Distances::too_near(const Valuation& all_choices) {
  bool near = false;
  const Valuation model = without(auxiliary_choices(solver_.trace()), all_choices);
  for (KeptAway& kept : kept_) {
    if (bound_.reached(overlap_of(model, shown(kept)))) continue;
    if (std::exchange(kept.told_in_pass, solver_.passes()) == solver_.passes())
      throw InternalError("a model is nearer to an earlier solution than its constraint allows");
    const Stopwatch watch(solver_.times().encode);
    const NodeId far = condition(kept);
    solver_.add_clause({&far, 1});
    near = true;
  }
  return near;
}

std::vector<NodeId> Distances::conditions() {
  std::vector<NodeId> conditions;
  for (const KeptAway& kept : kept_) conditions.push_back(condition(kept));
  return conditions;
}

/// The choices of an execution that leaves the paths explored so far are not known, so nothing is said of it.
NodeId Distances::condition(const KeptAway& kept) {
  return solver_.graph().disjunction(far_from(solver_.graph(), solver_.trace(), shown(kept), bound_),
                                     solver_.unexplored());
}

Valuation Distances::shown(const KeptAway& kept) const {
  return without(auxiliary_choices(solver_.trace()), kept.values);
}

}  // namespace solitaire
