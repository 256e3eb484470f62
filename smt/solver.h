#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/stop_signal.h"
#include "tracegraph/graph.h"

namespace solitaire {

enum class Verdict : std::uint8_t { kSatisfiable, kUnsatisfiable, kStopped };

/// The interface of all solver back ends. A solver is told bool nodes of one trace graph. Conditions are only
/// ever added, so that what it learned stays true; a condition that may be taken back is assumed for one
/// check.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Requires that at least one of the conditions holds from now on. With no conditions at all, nothing is
  /// satisfiable any more.
  virtual void add_clause(std::span<const NodeId> conditions) = 0;
  /// Decides whether all that was added and all of the assumptions can hold together. Returns kStopped if the
  /// signal or the limit of effort came first.
  virtual Verdict check(std::span<const NodeId> assumptions, const StopSignal& stop) = 0;
  /// Makes each check from now on end with kStopped after about so many conflicts of the search. With 0 there
  /// is no such limit.
  virtual void limit_effort(std::uint64_t conflicts) = 0;
  /// Suggests a value to try first for a choice in the checks to come. Returns false if this solver takes no
  /// suggestions.
  virtual bool suggest(std::size_t variable, std::int64_t value) = 0;
  /// Returns true if ints are exact. If they are not, some of them may have wrapped. Then a model may be no
  /// execution, and an unsatisfiable formula proves nothing.
  virtual bool exact() const { return true; }
  /// Returns the value of the choice variable with that number. For use after kSatisfiable.
  virtual std::int64_t value(std::size_t variable) = 0;
  /// Returns assumptions that cannot hold together with what was added. The list is empty if what was added
  /// is unsatisfiable by itself. For use after kUnsatisfiable.
  virtual std::vector<NodeId> core() = 0;
};

}  // namespace solitaire
