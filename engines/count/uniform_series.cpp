#include "engines/count/uniform_series.h"

namespace solitaire {

std::vector<Solution> UniformSeries::resume(const std::vector<KnownChoices>& earlier) {
  std::vector<Solution> known = run_all(engine_.tracing(), earlier);
  for (const KnownChoices& choices : earlier) engine_.exclude(choices);
  for (const Solution& solution : known) results_.add(solution.execution);
  return known;
}

std::optional<Solution> UniformSeries::next() {
  while (true) {
    std::optional<Solution> solution = engine_.next();
    if (!solution || results_.add(solution->execution) || !distinct_results_) return solution;
    ++alike_;
    engine_.pass_over();
  }
}

}  // namespace solitaire
