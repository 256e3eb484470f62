#pragma once
#include <string>
#include <vector>

#include "engines/explain/dead_asserts.h"
#include "engines/explain/explain.h"
#include "engines/explain/reachable_values.h"

namespace solitaire {

/// A program as a run has it.
struct RunOfProgram {
  const Program& program;
  const ParamValues& params;
  const std::vector<Pin>& pins;
  Limits limits;
  std::uint64_t most_executions = 100'000;  // by brute force, at a time
};

/// What brute force came to: what is wrong, "" if nothing; and whether it ran all executions that it needs to
/// say so, or gave up because there are too many or because they come to mistakes.
struct Checked {
  std::string wrong;
  bool complete = true;
};

/// Whether no execution fulfils all members of a conflict, and for each member some execution fulfils all
/// others, choices being free to lie outside of their ranges.
Checked check_conflict(const RunOfProgram& run, const Conflict& conflict, const AddressTable& addresses);

/// The same by both solvers, for programs of more executions than can be run. Nothing of it is taken from
/// the explainer but the solvers' formula.
Checked check_conflict_by_solvers(const RunOfProgram& run, const Conflict& conflict,
                                  const AddressTable& addresses);

/// Whether without the dead asserts the executions that fulfil all conditions are the same, and each other
/// assert, and each conjunct of it, rules some execution out that nothing else does but the dead ones.
Checked check_dead_asserts(const RunOfProgram& run, const DeadAsserts& asserts);

/// Whether the solutions have exactly these values.
Checked check_values(const RunOfProgram& run, const std::vector<ReachableValues>& choices,
                     const AddressTable& addresses);

}  // namespace solitaire
