#pragma once
#include <cstdint>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "solitaire/run/execution.h"
#include "solitaire/syntax/syntax.h"
#include "solitaire/value/value.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// A call of place() in a symbolic pass: what it was called with, and where.
struct SymbolicPlacement {
  Placement placement;
  const CallExpr* site = nullptr;
  std::vector<Value> arguments;                            // as of a BuiltinCall
  std::vector<std::pair<std::string_view, Value>> extras;  // likewise
};

/// What one symbolic pass found.
struct SymbolicPass {
  Trace trace;
  Value value;                                // of the program, where some path came to its end; else Unset
  std::vector<SymbolicPlacement> placements;  // as numbered by Trace::placed
  std::vector<Value> lists;                   // that were chosen from, as numbered by Trace::choices
  std::vector<NodeId> tile_neighbors;         // what maps of tiles ask of neighbours
  std::set<Span> unlike;          // the places that compare values of different kinds for equality
  std::vector<CallRecord> calls;  // on the way to placements
  double unit = 1;                // metres in one unit of the program
  bool unit_is_open = false;      // choices decide about it
  /// False if some of what an execution does shows only when it is run.
  bool complete = true;
  bool has_output = false;  // the program has an output, of which the pass says nothing
  std::uint64_t steps = 0;  // evaluated in all
};

}  // namespace solitaire
