#include "engines/sample/impossible.h"

#include <fmt/format.h>

#include "engines/tuning.h"

namespace solitaire {

ProgramError no_start(const std::optional<Rejection>& rejection) {
  Diagnostic diagnostic;
  diagnostic.message =
      fmt::format("none of {} executions drawn from the distributions is possible", tuning::kMostStarts);
  if (rejection) {
    diagnostic.span = rejection->whole;
    diagnostic.message += "; this ruled the last one out";
  }
  diagnostic.help =
      "draw choices so that asserts mostly hold; 'solitaire explain' says whether they ever can";
  return ProgramError(diagnostic);
}

}  // namespace solitaire
