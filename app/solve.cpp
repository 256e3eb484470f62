#include "app/commands.h"
#include "app/console.h"
#include "app/delivery.h"

namespace solitaire::app {

/// Finds solutions and prints them.
ExitStatus solve_command(const Options& options, Watchdog& watchdog) {
  Session session(options);
  const bool needs_looks = !options.quiet || session.search.distinct == Distinct::kResult;
  session.search.scene = needs_looks ? SceneDetail::kPlacements : SceneDetail::kNone;
  Search search(session.program, session.search);
  deliver_all(search, session, options, watchdog, [&](const Solution& solution) {
    print_result(options.json ? to_json(solution) + "\n" : to_text(solution));
  });
}

}  // namespace solitaire::app
