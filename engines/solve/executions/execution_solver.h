#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <unordered_set>
#include <vector>

#include "engines/solution_stream.h"
#include "engines/solve/conclusions/over_full.h"
#include "engines/solve/conclusions/separations.h"
#include "engines/solve/executions/explore.h"
#include "engines/solve/executions/options.h"
#include "engines/times.h"
#include "smt/solver.h"
#include "solitaire/run/evaluator.h"
#include "tracegraph/assignment.h"
#include "tracegraph/valuation.h"

namespace solitaire {

/// The choices that an execution meets.
struct TracedChoices {
  Valuation values;
  std::vector<NodeId> variables;  // of the trace, one for each value, in the same order
  bool complete = true;           // the execution stays on explored paths, so these are all of its choices
};

/// Looks for executions of a program that fulfil conditions: the trace graph of the program, grown where that
/// is needed, and a solver that knows its formula.
///
/// Blockers are assumed false; if nothing is found, the unsatisfiable core names those that stood in the way,
/// and the exploration goes on there. A core without blockers proves that there is no such execution.
class ExecutionSolver {
 public:
  /// Returns true for those of a trace's requirements that hold in every execution that is looked for. The
  /// others are the business of whoever asks.
  using Firm = std::function<bool(const Term&)>;

  /// `choices` answers what is not to be left open. `stream` tells apart solvers of one seed.
  ExecutionSolver(const Program& program, ParamValues params, const TracingOptions& options, Choices& choices,
                  Graph& graph, AddressTable& addresses, Firm firm, std::uint64_t stream = 0);
  ~ExecutionSolver();

  /// Runs the first passes, as far as the policy goes by itself. Throws Interrupted.
  void explore();
  /// Opens every side that some execution comes to, until none is left. Returns false if the policy or the
  /// number of passes does not allow that. Throws Interrupted.
  bool explore_fully(std::size_t most_passes = SIZE_MAX);

  /// Counts so few steps where paths join that no execution is refused for those of other paths, from a new
  /// pass on. Returns false if that was so already. Throws Interrupted.
  bool count_least_steps();

  enum class Outcome : std::uint8_t {
    kFound,
    kNone,        // proved
    kWrapped,     // none for a solver whose ints wrap
    kUnexplored,  // none on the paths that the policy explores
    kStopped,     // a limit came first, of effort too
  };
  /// Makes conditions that depend on the newest pass. They may only say what a longer execution that begins
  /// like one of the trace cannot undo, as a broken assert is; or else they hold where unexplored() does.
  using Conditions = std::function<std::vector<NodeId>()>;
  /// Says where an execution that is found may end, beside the end of the program: at an error, or at what a
  /// pass cannot express; and, with kErrorsAndCuts, also where its path was cut since it runs for long.
  enum class Ends : std::uint8_t { kNone, kErrors, kErrorsAndCuts };
  /// Looks for an execution that fulfils the conditions. They are asked for again after each further pass.
  Outcome find(const Conditions& conditions, Ends ends = Ends::kNone);
  /// Looks for an execution on the paths explored so far that fulfils the conditions. It may come to
  /// errors.
  Outcome find_explored(const Conditions& conditions, Ends ends = Ends::kNone);

  /// Requires that at least one of the conditions holds.
  void add_clause(std::span<const NodeId> conditions) { solver_->add_clause(conditions); }
  /// Adds a condition by itself, if it says anything.
  void require(NodeId condition) {
    if (condition != kTrue) solver_->add_clause({&condition, 1});
  }
  /// Makes the next search start from random values of the choices, so that it ends at a solution near them
  /// and not near the last one. The values depend on the seed and the index.
  void suggest_random_values(std::uint64_t index);

  /// Makes searches give up after so many conflicts, as if a limit had come. With 0 they never do.
  void limit_effort(std::uint64_t conflicts) { solver_->limit_effort(conflicts); }

  /// Returns conditions that follow from what is required, and that a search does not see by itself.
  const std::vector<NodeId>& implied() const { return implied_; }

  /// Returns the condition that an execution leaves the explored paths. The trace does not say all about such
  /// an execution.
  NodeId unexplored();

  /// Returns true if the solver's ints are exact, see Solver::exact.
  bool exact() const { return solver_->exact(); }

  /// Returns the values of the choices' variables. For use after kFound.
  Assignment assignment();
  /// Returns the choices that an execution with these values of the variables meets. Throws InternalError if
  /// two of them share an address.
  TracedChoices met(Assignment& assignment) const;
  /// Returns the conditions in the core. For use after kNone.
  const std::vector<NodeId>& core() const { return core_; }

  Graph& graph() { return graph_; }
  AddressTable& addresses() { return addresses_; }
  const Trace& trace() const { return explorer_.pass().trace; }
  const SymbolicPass& pass() const { return explorer_.pass(); }
  std::size_t passes() const { return explorer_.passes(); }
  EngineTimes& times() { return times_; }
  const EngineTimes& times() const { return times_; }

 private:
  void sync();
  void tell_required(NodeId required);
  void tell_over_full();
  void tell_sum_conflict(const std::vector<NodeId>& assumptions);
  void tell(const OverFull& conflict);
  std::vector<NodeId> closed_sides(Ends ends) const;
  Verdict check(std::vector<NodeId> assumptions);
  std::vector<std::size_t> blockers_in_core() const;
  bool open(const std::vector<std::size_t>& blockers);
  std::optional<std::vector<std::size_t>> blockers_reached();

  Graph& graph_;
  AddressTable& addresses_;
  TracingOptions options_;
  Firm firm_;
  Explorer explorer_;
  std::unique_ptr<Solver> solver_;
  std::set<std::uint32_t> required_;  // conditions the solver knows
  std::vector<NodeId> core_;
  StopSignal never_;
  EngineTimes times_;
  std::size_t synced_pass_ = 0;
  std::vector<NodeId> implied_, implied_sums_;  // as find_permutations() gives them
  std::unordered_set<NodeId> ruled_out_;
  std::vector<SignedNode> comparisons_;  // that every execution fulfils
  std::size_t counted_pass_ = 0;         // the pass whose sums were looked at
  int sums_in_vain_ = 0;                 // so many times in a row
  std::int64_t questions_to_skip_ = 0;   // before sums are looked at again
};

/// Says why there is no further solution when the search for one came to this.
Ending ending_of(ExecutionSolver::Outcome outcome);

}  // namespace solitaire
