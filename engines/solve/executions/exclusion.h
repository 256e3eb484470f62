#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "engines/solve/executions/auxiliary.h"
#include "engines/solve/executions/execution_solver.h"

namespace solitaire {

/// Keeps known solutions from being found again: the solver gets a clause for each, by which some choice has
/// another value (SearchMethod::difference).
///
/// Finding a known solution again by chance, and telling the solver of it only then, is less work where that
/// is rare: where solutions are many, and drawn at random. So a clause can wait until it is needed.
class Exclusion {
 public:
  Exclusion(ExecutionSolver& solver, const TracingOptions& options);

  /// Returns how many solutions are known.
  std::size_t size() const { return known_.size(); }
  /// Takes note of a solution without telling the solver.
  void add(Valuation values);
  /// Tells the solver of the last solution, unless that can wait.
  void tell_last();
  /// Tells the solver of all solutions that are on explored paths.
  void tell_all();
  /// Tells the solver again after a pass: which variable of the graph stands for a choice can change with it,
  /// since the domain of one whose ends depend on other choices grows with the paths that are open.
  void meet_pass();
  /// Returns true if the model is a known solution; then the solver was told of it, and has to be asked
  /// again.
  bool repeats(const Valuation& model);
  /// Returns what the solver was told, a condition for each solution.
  std::vector<NodeId> conditions();

 private:
  struct Known {
    Valuation values;
    /// The clause of which the solver was told last, or nothing while it does not know the solution.
    std::optional<std::vector<NodeId>> differs;
  };

  /// What tells solutions apart: the values of the choices that are not auxiliary.
  Valuation key(const Valuation& values) const {
    return auxiliary_.empty() ? values : without(auxiliary_, values);
  }
  void find_auxiliary();
  void tell(Known& known);
  std::vector<NodeId> difference(const TracedChoices& met, Assignment& assignment);
  bool tells_at_once() const;

  ExecutionSolver& solver_;
  const SearchMethod& method_;
  bool diverse_;
  bool relax_;
  Apart apart_;
  std::vector<Known> known_;
  std::unordered_set<AddressId> auxiliary_;
  std::unordered_multimap<std::uint64_t, std::size_t> by_hash_;  // numbers of known solutions
  std::size_t repeated_ = 0;                                     // models that were known solutions
};

/// The assignment that gives each variable of the graph the value that its choice has, or its lowest value.
/// `possible`, if any, becomes false once a value is asked for that its choice cannot have. The valuation
/// has to outlive the assignment.
Assignment assignment_of(const Graph& graph, const Valuation& values, bool* possible = nullptr);

}  // namespace solitaire
