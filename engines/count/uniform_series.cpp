#include "engines/count/uniform_series.h"

#include "engines/resume.h"

namespace solitaire {

std::vector<Solution> UniformSeries::resume(const std::vector<ChosenValues>& earlier) {
  std::vector<Solution> known =
      run_all(earlier, [this](const ChosenValues& choices) { return engine_.run(choices); });
  for (const ChosenValues& choices : earlier) engine_.exclude(choices);
  for (const Solution& solution : known) results_.add(solution);
  return known;
}

std::optional<Solution> UniformSeries::next() {
  while (true) {
    std::optional<Solution> solution = engine_.next();
    if (!solution || results_.add(*solution) || apart_ == Apart::kChoices) return solution;
    ++alike_;
    engine_.pass_over();
  }
}

}  // namespace solitaire
