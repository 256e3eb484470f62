#pragma once
#include <set>

#include "engines/solve/conclusions/over_full.h"
#include "engines/solve/executions/execution_solver.h"
#include "engines/solve/pins/conditions.h"

namespace solitaire {

/// Asks which conditions of a program can hold together. A condition that is left out is one that executions
/// may break: they go on past a broken assert or a choice outside of its range, and end where a list has no
/// element or nothing is there to choose from. They also end where they come to an error of the program or
/// to what a pass cannot express, or run for long: its asserts may be there to keep them from that.
class ConditionSolver {
 public:
  using Outcome = ExecutionSolver::Outcome;
  using Ends = ExecutionSolver::Ends;
  using Conditions = std::set<Condition>;
  using Wanted = std::function<bool(const Condition&)>;

  ConditionSolver(const Program& program, const ParamValues& params, const TracingOptions& options,
                  Choices& choices, AddressTable& addresses, Pins& pins);

  /// Returns all conditions that have been met so far. Throws Interrupted.
  const std::vector<TracedCondition>& all();
  /// Says of what a core is made: of single conditions, of all those that stand at one place of the text,
  /// such as those of a loop's turns, or of all of them. The fewer parts, the easier the question.
  enum class Grain : std::uint8_t { kConditions, kPlaces, kAll };
  /// Asks whether those that are wanted can hold together, and with them `also`, a bool node of graph().
  Outcome find(const Wanted& wanted, const std::function<NodeId()>& also = nullptr,
               Ends ends = Ends::kErrorsAndCuts, Grain grain = Grain::kConditions);
  Outcome find(const Conditions& wanted, Grain grain = Grain::kConditions);
  /// Returns true if no path is left that was not explored.
  bool is_explored() { return all(), solver_.trace().blockers.empty(); }
  /// Returns how often the newest pass met what it cannot express.
  std::size_t inexpressible();
  /// Returns things that need more room than there is, if the conditions say that there are such.
  std::optional<OverFull> over_full(const Conditions& conditions);
  /// Returns wanted conditions that cannot hold together; of several parts that mean the same, only one. For
  /// use after kNone.
  Conditions core();
  /// Returns the addresses of the choices that the conditions depend on.
  std::set<AddressId> choices_below(const Conditions& conditions);

  /// Makes each search give up after so many conflicts. With 0 they never do.
  void limit_effort(std::uint64_t conflicts) { solver_.limit_effort(conflicts); }

  Graph& graph() { return graph_; }

 private:
  Graph graph_;
  Pins& pins_;
  ExecutionSolver solver_;
  std::vector<TracedCondition> traced_;
  std::size_t traced_pass_ = 0;
  /// What the core has as a whole, or not at all.
  struct Part {
    NodeId holds = kTrue;
    std::vector<const Condition*> conditions;
  };
  std::vector<Part> parts_of(const Wanted& wanted, Grain grain);

  std::vector<Part> asked_;  // what the last find() asked for
};

}  // namespace solitaire
