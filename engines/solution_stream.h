#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engines/errors.h"
#include "engines/solution.h"
#include "engines/times.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Why a stream has no further solution.
enum class Ending : std::uint8_t {
  kNone,        // it may have one
  kExhausted,   // proved that there is none
  kUnexplored,  // there is none on the paths that were explored; others were not looked at
  kWrapped,     // there is none for a solver whose ints wrap
  kStopped,     // a limit or an interrupt came first
};

/// Whatever gives solutions, one after the other, each different from those before: the one interface of all
/// engines. What some of them can do beyond that are abilities, interfaces of their own below, for which
/// ability_of() asks.
class SolutionStream {
 public:
  virtual ~SolutionStream() = default;
  /// Returns the next solution, or nothing; then ending() says why.
  /// Throws ProgramError for an error of the program, and InternalError if the engine itself is wrong.
  virtual std::optional<Solution> next() = 0;
  virtual Ending ending() const = 0;
};

/// Returns the stream's ability of that kind, or null if it does not have it.
template <class Ability>
Ability* ability_of(SolutionStream& stream) {
  return dynamic_cast<Ability*>(&stream);
}

/// The ability to go on where an earlier stream was interrupted, with exactly the solutions that would have
/// come next, given those that came.
class Resumable {
 public:
  virtual ~Resumable() = default;
  /// Goes on after these solutions, and returns them, run again. To be called before anything else.
  /// Throws NotASolution, whose message names the one that is none, and Interrupted.
  virtual std::vector<Solution> resume(const std::vector<ChosenValues>& earlier) = 0;
  /// Does again what is needed to go on. next() does so too, but there it counts as a search for one
  /// solution. Returns false if a limit came first. Throws Interrupted.
  virtual bool catch_up() = 0;
};

/// The ability to make a solution better before it is returned.
class Improving {
 public:
  virtual ~Improving() = default;
  /// Sets a function that is told, while the next solution is looked for, of each one that is better than the
  /// one before. It is called on the thread that called next().
  virtual void on_improvement(std::function<void(const Solution&)> told) = 0;
};

/// The work of an engine that explores a program before it can look for solutions.
class Exploring {
 public:
  virtual ~Exploring() = default;
  /// Does the work that comes before the search for the first solution, which next() does by itself else.
  /// Throws Interrupted.
  virtual void explore() = 0;
  /// Returns the number of nodes of the trace graph so far.
  virtual std::size_t graph_size() const = 0;
};

/// The conditions that hold in all solutions that are left, as bool nodes of a graph.
struct Formula {
  const Graph& graph;
  const AddressTable& addresses;
  std::vector<NodeId> conditions;
};

/// The ability to say in a formula which solutions are left.
class WithFormula {
 public:
  virtual ~WithFormula() = default;
  /// Returns all that holds in the solutions that did not come yet. After Ending::kExhausted no values of
  /// the choices fulfil it. The graph belongs to the stream. Throws Interrupted.
  virtual Formula formula_of_rest() = 0;
};

/// Tells how many solutions were left out because they look like others.
class CountingAlike {
 public:
  virtual ~CountingAlike() = default;
  /// May be called from another thread.
  virtual std::uint64_t alike() const = 0;
  /// Returns true if some of them, or of those that were not looked for, differ in names or extras of placed
  /// things.
  virtual bool names_differed() const = 0;
};

/// Tells where the time went.
class Timed {
 public:
  virtual ~Timed() = default;
  /// Returns the times of all searches so far, whatever thread they ran on.
  virtual EngineTimes times() const = 0;
};

}  // namespace solitaire
