#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solitaire/names/program.h"
#include "solitaire/value/placed_item.h"
#include "solitaire/value/value.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// A call on the way to a placed thing.
struct CallRecord {
  std::uint32_t caller;      // its number in the same list, or kNoCall
  AddressId address;         // of the call
  const Function* function;  // that was called
  Span span;                 // where it was called
};
inline constexpr std::uint32_t kNoCall = UINT32_MAX;

/// A placed thing during a run. From its own members, add_texts() makes `address`, `calls`, `source` and
/// `folder`.
struct Placement : PlacedItem {
  AddressId id;
  Span span;
  std::uint32_t call = kNoCall;  // in Execution::calls
};

/// Why an execution was ruled out.
struct Rejection {
  ConstraintKind requirement = ConstraintKind::kAssert;
  Span span;  // of a conjunct of the condition, as in a Term
  Span whole;
  std::string address;
  std::string message;  // the author's, or ""
  AddressId id;         // from which add_texts() makes `address`
};

/// The cost to an execution of a wish of the program: prefer, minimize or maximize.
struct WishCost {
  std::int64_t cost = 0;
  Span span;
  std::string address;
  AddressId id;  // from which add_texts() makes `address`
};

/// A choice that an execution met.
struct MetChoice {
  AddressId address;
  Distribution domain;
  TypedScalar value;
  Value element;           // of choose(list): what it chose, else Unset
  bool auxiliary = false;  // as of a TraceChoice
};

/// A map of tiles that was chosen: its sites are choices that follow each other, row by row from the top.
struct TileMap {
  std::size_t first_choice;  // in Execution::choices
  std::int64_t width, height;
  Value source;  // what its set of tiles was learned from (tile_pairs): rows of numbers, or a file's name
};

/// The result of one run with answered choices.
struct Execution {
  std::optional<Rejection> rejection;  // nothing in a solution
  std::vector<Rejection> broken;       // asserts past which it went on; see Limits::keep_going
  std::vector<WishCost> wishes;        // in the order in which they were met
  std::int64_t cost = 0;               // the sum of theirs
  double log_weight = 0;               // the sum of all factors, natural logarithms
  std::optional<Span> weightless;      // the first factor of weight 0
  Value value;                         // what the program returned
  Value before_output;                 // what it had returned before its output; Unset if it has none
  std::vector<MetChoice> choices;      // in the order in which they were met
  std::vector<TileMap> tile_maps;
  std::vector<Placement> placements;
  std::vector<CallRecord> calls;     // on the way to placements
  double unit = 1;                   // metres in one unit of the program
  std::vector<std::string> printed;  // lines
};

/// Writes the texts of an execution's addresses, calls and places, which cost more than the execution itself.
void add_texts(Execution& execution, const Program& program, const AddressTable& addresses);
/// Does so for one placement, whose call is one of `calls`.
void add_texts(Placement& placement, const std::vector<CallRecord>& calls, const Program& program,
               const AddressTable& addresses);

/// A condition that a traced execution followed at a branch.
struct PathCondition {
  NodeId holds;  // is true wherever an execution takes the same side
  Span span;
};

/// An execution, and how all that it came to comes from its choices, as nodes of a graph. The nodes say what
/// executions with other values of the choices come to, as long as they take the same path.
struct TracedExecution {
  Execution execution;              // its value carries nodes
  Trace trace;                      // choices, asserts, wishes and placed things, each under the guard true
  std::vector<PathCondition> path;  // in the order in which they were met
};

}  // namespace solitaire
