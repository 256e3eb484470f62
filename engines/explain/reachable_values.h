#pragma once
#include <set>

#include "engines/solve/execution_solver.h"

namespace solitaire {

/// Which values a choice takes in the solutions of a program.
struct ReachableValues {
  AddressId address;
  Span span;
  Distribution domain;            // over all paths
  std::set<std::int64_t> values;  // that occur: all of them, or where there are too many the least and most
  bool listed = true;             // whether `values` is all of them
  bool pinned = false;
  bool complete = true;  // whether no limit came first
  /// Returns true if some value of the domain never occurs.
  bool restricted() const;
};

/// For every choice that the program makes, in the order in which it is met; each is told as soon as it is
/// known. Choices of many values are described by the least and the greatest.
void find_reachable_values(const Program& program, const ParamValues& params, const TracingOptions& options,
                           AddressTable& addresses, const std::function<void(const ReachableValues&)>& told);

}  // namespace solitaire
