#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/stop_signal.h"
#include "tracegraph/graph.h"

namespace solitaire {

enum class Verdict : std::uint8_t { kSatisfiable, kUnsatisfiable, kStopped };

/// What every solver back end can do with the bool nodes of one trace graph. Conditions are only ever added,
/// so that what a solver learned stays true; what may be taken back is assumed in a check.
class Solver {
 public:
  virtual ~Solver() = default;

  /// From now on at least one of the conditions holds. None at all: nothing is satisfiable any more.
  virtual void add_clause(std::span<const NodeId> conditions) = 0;
  /// Whether everything added and all of the assumptions can hold together. kStopped if the signal or
  /// the limit of effort came first.
  virtual Verdict check(std::span<const NodeId> assumptions, const StopSignal& stop) = 0;
  /// From now on a check ends with kStopped after about so many conflicts of the search; 0: it does not.
  virtual void limit_effort(std::uint64_t conflicts) = 0;
  /// A value to try first for a choice, in the checks to come. False if this solver takes no suggestions.
  virtual bool suggest(std::size_t variable, std::int64_t value) = 0;
  /// Whether ints are exact. If not, some of them may have wrapped: a model may then be no execution, and an
  /// unsatisfiable formula no proof.
  virtual bool exact() const { return true; }
  /// After kSatisfiable: the value of the choice variable with that number.
  virtual std::int64_t value(std::size_t variable) = 0;
  /// After kUnsatisfiable: assumptions that cannot hold together with what was added. Empty: nothing assumed
  /// matters.
  virtual std::vector<NodeId> core() = 0;
};

}  // namespace solitaire
