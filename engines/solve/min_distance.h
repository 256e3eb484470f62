#pragma once
#include <map>

#include "engines/distance.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// What distances are to be at least, as an exact fraction: part / whole.
struct DistanceBound {
  std::int64_t part = 0;
  std::int64_t whole = 1;

  /// The bound, 0 to 1, to six digits.
  static DistanceBound of(double bound);
  /// Whether there is anything to keep to.
  bool any() const { return part > 0; }
  bool reached(const Overlap& overlap) const;
};

/// The choices of a solution.
using ChoiceValues = std::map<AddressId, std::int64_t>;

/// Whether an execution's choices are as far from the solution's as the bound says, for executions on the
/// paths that the trace explored: a cardinality constraint. With the number `shared` of choices that both
/// meet with the same value, and the number `extra` of those that only the execution meets:
///
///     whole * shared <= (whole - part) * (number of the solution's choices + extra)
///
/// which is part / whole <= Overlap::distance().
NodeId far_from(Graph& graph, const Trace& trace, const ChoiceValues& solution, const DistanceBound& bound);

}  // namespace solitaire
