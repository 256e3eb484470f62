#include "engines/exhaustive/exhaustive.h"

#include "engines/freeze.h"

namespace solitaire {

ExhaustiveEngine::ExhaustiveEngine(const Program& program, ParamValues params, const Limits& limits)
    : program_(program),
      params_(std::move(params)),
      limits_(limits),
      executor_(program_, params_, addresses_, limits_) {}

std::optional<Solution> ExhaustiveEngine::next() {
  while (ending_ == Ending::kNone) {
    if (!odometer_.advance()) {
      ending_ = Ending::kExhausted;
      break;
    }
    ++executions_;
    try {
      if (limits_.stop != nullptr && limits_.stop->stopped()) throw Interrupted{};
      Execution& execution = executor_.run(odometer_);
      if (execution.rejection) continue;
      add_texts(execution, program_, addresses_);
      return solution_of(std::move(execution), addresses_);
    } catch (const Interrupted&) {
      ending_ = Ending::kStopped;
    }
  }
  return std::nullopt;
}

}  // namespace solitaire
