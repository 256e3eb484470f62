#pragma once
#include <string>
#include <vector>

#include "engines/sample/rerun.h"
#include "engines/sample/returned_numbers.h"
#include "engines/sample/shred/block_draw.h"
#include "engines/sample/shred/passages.h"
#include "kernel/kernel.h"

namespace solitaire {

/// The executions that take one path, as a kernel.
struct TracedStructure {
  Kernel kernel;
  std::vector<std::string> names;  // of the numbers that the program returns, which are the kernel's outputs
  bool branches;                   // whether a branch depends on some choice
  Passages passages;
  BlockDraw block;

  /// Returns true if no change of the choice leads to another path.
  bool keeps_path(ChoiceNumber choice) const { return kernel.slice(choice).assumed.empty(); }
  /// Returns true if an execution with these choices takes this path; then the kernel has its values.
  bool load(const SampledState& state);
};

/// Traces the execution that is the state. Throws ProgramError where the trace cannot say what the program
/// does, as where an int could grow past 62 bits.
TracedStructure trace_structure(const Program& program, const ParamValues& params, const SampledState& state,
                                AddressTable& addresses, const Limits& limits,
                                const ReturnedNumbers& returned);

/// The kernel's values as a state, but for the value that the program returns. The kernel is refreshed.
SampledState state_of(const Kernel& kernel);
/// The logarithm of the density with which the choice is drawn to be what it is.
double log_prior(const Kernel& kernel, ChoiceNumber choice);

}  // namespace solitaire
