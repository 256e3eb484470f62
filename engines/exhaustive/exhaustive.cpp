#include "engines/exhaustive/exhaustive.h"

namespace solitaire {

ExhaustiveEngine::ExhaustiveEngine(const Program& program, ParamValues params, const Limits& limits)
    : program_(program), params_(std::move(params)), limits_(limits) {}

std::optional<Solution> ExhaustiveEngine::next() {
  while (ending_ == Ending::kNone) {
    if (!odometer_.advance()) {
      ending_ = Ending::kExhausted;
      break;
    }
    ++executions_;
    try {
      if (limits_.stop != nullptr && limits_.stop->stopped()) throw Interrupted{};
      Execution execution = execute(program_, params_, odometer_, addresses_, limits_);
      if (execution.rejection) continue;
      Solution solution;
      solution.choices = execution.choices;
      solution.answers = readable(solution.choices, addresses_);
      solution.execution = std::move(execution);
      return solution;
    } catch (const Interrupted&) {
      ending_ = Ending::kStopped;
    }
  }
  return std::nullopt;
}

}  // namespace solitaire
