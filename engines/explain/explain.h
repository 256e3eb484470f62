#pragma once
#include <functional>

#include "engines/solve/executions/condition_solver.h"

namespace solitaire {

/// Conditions that cannot hold together.
struct Conflict {
  std::vector<Condition> members;  // in the order of the program's text
  bool minimal = true;             // it is proved that without any one of them the others can hold
  std::optional<OverFull> room = std::nullopt;  // what needs more room than there is, if that is why
};

/// Says why a program has no solution: minimal sets of conditions that cannot hold together (minimal
/// unsatisfiable subsets, found by deletion from the solver's cores).
class Explainer {
 public:
  /// Unless it is `thorough`, questions are given up that take long, where a conflict has many members.
  Explainer(const Program& program, ParamValues params, const TracingOptions& options, bool thorough = false);

  /// A conflict none of whose conditions is in one that was found before; nothing if there is no further one,
  /// or if the work ended early: then ending() says so.
  std::optional<Conflict> next_conflict();
  /// `told` is called with each conflict that is known on the way to the next one: it gets smaller, and may
  /// have members that are not needed.
  void on_smaller(std::function<void(const Conflict&)> told) { told_ = std::move(told); }
  /// kExhausted: all independent conflicts were found.
  Ending ending() const { return ending_; }
  const AddressTable& addresses() const { return addresses_; }

 private:
  using Conditions = ConditionSolver::Conditions;
  using Grain = ConditionSolver::Grain;
  using Outcome = ConditionSolver::Outcome;

  /// Choices that are free to lie outside of their ranges, and at least how far.
  struct Freedom {
    std::set<AddressId> choices;
    std::int64_t reach;
  };

  std::optional<Conflict> another_conflict();
  Outcome find_unexplained();
  void minimize_places(Conditions& members);
  bool minimize(ConditionSolver& solver, Conditions& members, const Conditions& fixed) const;
  std::size_t leave_out(ConditionSolver& solver, Conditions& members, Conditions& needed,
                        std::size_t most_open) const;
  bool is_many(const Conditions& members) const;
  Conflict complete(Conditions members, bool minimal);
  void tell(const Conditions& members) const;
  std::optional<Freedom> choices_below(const Conditions& members);

  const Program& program_;
  ParamValues params_;
  TracingOptions options_;
  bool thorough_;
  AddressTable addresses_;
  Pins pins_;
  PinnedFloats choices_;
  ConditionSolver solver_;
  Conditions explained_;  // members of the conflicts so far, but for ends of ranges
  Conditions shown_;      // members of the conflicts that were returned
  std::function<void(const Conflict&)> told_;
  Ending ending_ = Ending::kNone;
};

}  // namespace solitaire
