#pragma once
#include <cstdint>
#include <limits>
#include <set>

#include "engines/exhaustive/exhaustive_choices.h"
#include "engines/solution_stream.h"
#include "solitaire/run/evaluator.h"
#include "tracegraph/valuation.h"

namespace solitaire {

/// Runs every execution of a program, one after the other, depth first over its choices: the definition of
/// what the solutions are, and nothing cleverer. For programs whose executions can be counted, and for
/// testing other engines.
class ExhaustiveEngine : public SolutionStream {
 public:
  /// Ends after so many executions at most, with Ending::kStopped if there are more.
  ExhaustiveEngine(const Program& program, ParamValues params, const Limits& limits,
                   std::uint64_t most_executions = std::numeric_limits<std::uint64_t>::max());

  std::optional<Solution> next() override;
  Ending ending() const override { return ending_; }
  /// The number of executions run so far, solutions or not.
  std::uint64_t executions() const { return executions_; }

 private:
  bool is_new(const Execution& execution);

  const Program& program_;
  ParamValues params_;
  Limits limits_;
  AddressTable addresses_;
  Executor executor_;
  ExhaustiveChoices odometer_;
  std::set<Valuation> known_;  // what tells solutions with auxiliary choices apart
  Ending ending_ = Ending::kNone;
  std::uint64_t most_executions_;
  std::uint64_t executions_ = 0;
};

}  // namespace solitaire
