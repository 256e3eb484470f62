#include "engines/sample/impossible.h"

#include <fmt/format.h>

#include "engines/tuning.h"

namespace solitaire {

ProgramError no_start(const std::optional<Span>& ruled_out) {
  Diagnostic diagnostic;
  diagnostic.message =
      fmt::format("none of {} executions drawn from the distributions is possible", tuning::kMostStarts);
  if (ruled_out) {
    diagnostic.span = *ruled_out;
    diagnostic.message += "; this ruled the last one out";
  }
  diagnostic.help =
      "draw choices so that asserts mostly hold and data can be observed; where solvers can look at all "
      "choices, 'solitaire explain' says whether the asserts ever can";
  return ProgramError(diagnostic);
}

}  // namespace solitaire
