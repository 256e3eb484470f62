#pragma once
#include <cstdint>

#include "engines/distance.h"
#include "tracegraph/trace.h"
#include "tracegraph/valuation.h"

namespace solitaire {

/// The least distance that is wanted, as an exact fraction: part / whole.
struct DistanceBound {
  std::int64_t part = 0;
  std::int64_t whole = 1;

  /// Makes the bound of a number from 0 to 1, to six digits.
  static DistanceBound of(double bound);
  /// Returns true if there is anything to keep to.
  bool any() const { return part > 0; }
  bool reached(const Overlap& overlap) const;
};

/// Returns the condition that an execution's choices are as far from the solution's as the bound says, for
/// executions on the paths that the trace explored: a cardinality constraint. With the number `shared` of
/// choices that both meet with the same value, and the number `extra` of those that only the execution meets:
///
///     whole * shared <= (whole - part) * (number of the solution's choices + extra)
///
/// which is part / whole <= Overlap::distance().
NodeId far_from(Graph& graph, const Trace& trace, const Valuation& solution, const DistanceBound& bound);

}  // namespace solitaire
