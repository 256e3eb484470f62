#pragma once
#include <set>

#include "engines/solve/executions/execution_solver.h"

namespace solitaire {

/// The values that a choice takes in the solutions of a program.
struct ReachableValues {
  AddressId address;
  Span span;
  Distribution domain;            // over all paths
  std::set<std::int64_t> values;  // all that occur or, if there are too many, the least and the greatest
  /// Of choose(): the elements, by their positions, where they have short texts (elements.h).
  std::vector<std::string> elements = {};
  bool listed = true;  // `values` has all of them
  bool pinned = false;
  bool auxiliary = false;
  bool complete = true;  // no limit came first
  /// Returns true if some value of the domain never occurs.
  bool restricted() const;
};

/// Finds the values of every choice that the program makes, in the order in which choices are met. `told` is
/// called for each as soon as it is known. Auxiliary choices are left out unless they are asked for. Choices
/// of many values are described by the least and the greatest.
void find_reachable_values(const Program& program, const ParamValues& params, const TracingOptions& options,
                           AddressTable& addresses, bool with_auxiliary,
                           const std::function<void(const ReachableValues&)>& told);

}  // namespace solitaire
