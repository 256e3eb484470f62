#include "engines/solve/solution_source.h"

#include <fmt/format.h>

namespace solitaire {

std::vector<Solution> run_all(TracingEngine& engine, const std::vector<KnownChoices>& known) {
  std::vector<Solution> solutions;
  for (const KnownChoices& choices : known) {
    try {
      solutions.push_back(engine.run(choices));
    } catch (const NotASolution& error) {
      throw NotASolution(
          fmt::format("solution {} is none of this program: {}", solutions.size() + 1, error.what()));
    }
  }
  return solutions;
}

}  // namespace solitaire
