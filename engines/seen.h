#pragma once
#include <vector>

#include "engines/solution.h"
#include "solitaire/run/evaluator.h"
#include "tracegraph/assignment.h"

namespace solitaire {

/// Returns true if all of the value is in its text.
bool is_sayable(const Value& value);
/// The arguments of a call of place() that decide what the thing looks like.
std::vector<Value> look_arguments(const SymbolicPlacement& placement);

/// Returns true if the nodes of a pass say what tells solutions apart there.
bool says_what_is_seen(const SymbolicPass& pass, Apart apart);
/// Returns true if a name or an extra of a placed thing, which are not seen, depends on choices.
bool chooses_names(const SymbolicPass& pass);
/// Returns conditions. An execution on the paths of the pass in which something else is seen than in the one
/// with this assignment fulfils one of them; one in which the same is seen, with each thing placed by the
/// same call, fulfils none.
std::vector<NodeId> something_else(Graph& graph, const SymbolicPass& pass, Apart apart,
                                   Assignment& assignment);

}  // namespace solitaire
