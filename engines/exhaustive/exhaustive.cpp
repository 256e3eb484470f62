#include "engines/exhaustive/exhaustive.h"

#include "engines/freeze.h"

namespace solitaire {

ExhaustiveEngine::ExhaustiveEngine(const Program& program, ParamValues params, const Limits& limits,
                                   std::uint64_t most_executions)
    : program_(program),
      params_(std::move(params)),
      limits_(limits),
      executor_(program_, params_, addresses_, limits_),
      most_executions_(most_executions) {}

std::optional<Solution> ExhaustiveEngine::next() {
  while (ending_ == Ending::kNone) {
    if (!odometer_.advance()) {
      ending_ = Ending::kExhausted;
      break;
    }
    if (executions_ == most_executions_) {
      ending_ = Ending::kStopped;
      break;
    }
    ++executions_;
    try {
      if (limits_.stop != nullptr && limits_.stop->stopped()) throw Interrupted{};
      Execution& execution = executor_.run(odometer_);
      if (execution.rejection) continue;
      if (!is_new(execution)) continue;
      add_texts(execution, program_, addresses_);
      return solution_of(std::move(execution), addresses_);
    } catch (const Interrupted&) {
      ending_ = Ending::kStopped;
    }
  }
  return std::nullopt;
}

/// Executions that differ in auxiliary choices alone are one solution.
bool ExhaustiveEngine::is_new(const Execution& execution) {
  Valuation shown;
  for (const MetChoice& choice : execution.choices) {
    if (!choice.auxiliary) shown.emplace(choice.address, choice.value);
  }
  if (shown.size() == execution.choices.size()) return true;
  return known_.insert(std::move(shown)).second;
}

}  // namespace solitaire
