#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/search.h"
#include "app/solution_json.h"

namespace solitaire {
namespace {

std::string as_text(std::uint64_t number, const Solution& solution, const SourceSet& sources) {
  std::string text = fmt::format("solution {}: {}\n", number, to_text(solution.execution.value));
  if (solution.quality) text += fmt::format("  {}\n", quality_text(solution));
  for (const Rejection& broken : solution.execution.broken)
    text += fmt::format("  broken: {}\n", broken_text(broken, sources));
  for (const AnsweredChoice& choice : solution.answers) {
    text += fmt::format("  {} = {}\n", choice.address, to_text(choice.value));
  }
  return text;
}

}  // namespace

ExitStatus solve(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  const bool needs_looks = !options.quiet || options.distinct == Distinct::kResult;
  Search search(session, options, watchdog, needs_looks ? SceneDetail::kPlacements : SceneDetail::kNone);
  const auto shown = options.json ? solution_line : as_text;
  return search.run([&](std::uint64_t number, const Solution& solution) {
    print_result(shown(number, solution, session.program().sources));
  });
}

}  // namespace solitaire
