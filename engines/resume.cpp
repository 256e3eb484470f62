#include "engines/resume.h"

#include <fmt/format.h>

#include "engines/errors.h"

namespace solitaire {

std::vector<Solution> run_all(const std::vector<ChosenValues>& known,
                              const std::function<Solution(const ChosenValues&)>& run) {
  std::vector<Solution> solutions;
  for (const ChosenValues& choices : known) {
    try {
      solutions.push_back(run(choices));
    } catch (const NotASolution& error) {
      throw NotASolution(
          fmt::format("solution {} is none of this program: {}", solutions.size() + 1, error.what()));
    }
  }
  return solutions;
}

}  // namespace solitaire
