#pragma once
#include <functional>
#include <optional>

#include "app/session.h"
#include "app/watchdog.h"

namespace solitaire::app {

using Found = std::function<void(const Solution& solution)>;
/// Is told why there is no further solution; nothing if an error came.
using Close = std::function<void(std::optional<Ending> ending)>;

/// Hands the solutions of a search to `found` as they come. Shows progress while it runs and a summary at the
/// end, both on standard error; there too goes what solutions print. After the last solution, and whatever
/// ends the search, comes `close`.
///
/// The watchdog may be the one who ends the search: both functions are called while delivering, and then on
/// another thread, while the engine is at work.
///
/// Ends the process in the end, but for an exception: nobody needs the memory any more, and to take the graph
/// and the solver apart is a tenth of the time of a short run.
[[noreturn]] void deliver_all(
    Search& search, const Session& session, const Options& options, Watchdog& watchdog, const Found& found,
    const Close& close = [](std::optional<Ending>) {});

}  // namespace solitaire::app
