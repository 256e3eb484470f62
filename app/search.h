#pragma once
#include <functional>

#include "app/progress.h"
#include "app/session.h"
#include "app/watchdog.h"
#include "engines/distinct.h"

namespace solitaire {

/// Looks for as many solutions as the options ask for, and hands each to `found` as it comes, with its number
/// from 1. Shows progress while it runs and a summary at the end, both on standard error; there too goes what
/// solutions print. After the last solution, and whatever ends the search, comes `close`.
///
/// The watchdog may be the one who ends the search: both functions are called while delivering, and `close`
/// on another thread, while the engine is at work.
class Search {
 public:
  using Found = std::function<void(std::uint64_t number, const Solution& solution)>;
  using Close = std::function<void()>;

  Search(const Session& session, const Options& options, Watchdog& watchdog);
  ExitStatus run(
      const Found& found, const Close& close = [] {});

  const TracingEngine& engine() const { return engine_; }

 private:
  bool wants_more() const { return options_.all || solutions_ < options_.count; }
  Ending deliver_all(const Found& found, Progress& progress);
  std::optional<Solution> next_different(Progress& progress);
  ExitStatus finish(Ending ending, const Close& close) const;
  ExitStatus status(Ending ending) const;
  void summarize(Ending ending) const;
  void explain_dead_end() const;

  const Session& session_;
  const Options& options_;
  Watchdog& watchdog_;
  TracingEngine engine_;
  DistinctResults results_;
  std::uint64_t solutions_ = 0;           // delivered; changes only while delivering
  std::atomic<std::uint64_t> alike_ = 0;  // solutions that looked like earlier ones
  /// Given back where there is no more memory, for what is to be done then. It is not touched, so it takes
  /// none from the machine.
  std::unique_ptr<std::byte[]> reserve_ = std::make_unique_for_overwrite<std::byte[]>(std::size_t{32} << 20);
  StopSignal::Clock::time_point start_ = StopSignal::Clock::now();
};

}  // namespace solitaire
