#include "engines/exhaustive.h"

namespace solitaire {

ExhaustiveEngine::ExhaustiveEngine(const Program& program, ParamValues params, const Limits& limits)
    : program_(program), params_(std::move(params)), limits_(limits) {}

std::optional<std::int64_t> ExhaustiveEngine::Odometer::answer(AddressId, const ChoiceDomain& domain) {
  // The same answers so far lead to the same next choice, so the digits read so far are this execution's.
  if (depth_ == digits_.size()) digits_.push_back({domain.lo, domain.hi, domain.step});
  return digits_[depth_++].value;
}

bool ExhaustiveEngine::Odometer::advance() {
  while (!digits_.empty()) {
    Digit& last = digits_.back();
    if (last.value + last.step <= last.hi) {
      last.value += last.step;
      return true;
    }
    digits_.pop_back();
  }
  return false;
}

std::optional<Solution> ExhaustiveEngine::next() {
  while (ending_ == Ending::kNone) {
    if (executions_ > 0 && !odometer_.advance()) {
      ending_ = Ending::kExhausted;
      break;
    }
    odometer_.rewind();
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
