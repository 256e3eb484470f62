#include <fmt/format.h>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/console.h"
#include "app/delivery.h"

namespace solitaire::app {

/// Finds solutions and writes each as a scene, with a page that shows all.
ExitStatus generate_command(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  Search search(session.program, session.search);
  OutputFolder output(options.output, session.program, session.search, options.timings, options.pictures,
                      options.instancing);
  if (options.resume) output.resume(search);
  const auto found = [&](const Solution& solution) {
    output.add(solution, search.summary());
    if (solution.quality && !options.quiet)
      tell(fmt::format("{}-{:04}: {}\n", session.program.name(), solution.number, quality_text(solution)));
    if (options.json) print_result(to_json(solution) + "\n");
  };
  const auto close = [&](std::optional<Ending> ending) {
    const auto page = output.close(ending, search.stop_token().reason());
    for (const std::string& note : options.quiet ? std::vector<std::string>() : output.notes())
      tell(note + "\n");
    if (page && !options.quiet) tell(fmt::format("see {}\n", page->string()));
  };
  deliver_all(search, session, options, watchdog, found, close);
}

}  // namespace solitaire::app
