#pragma once
#include <atomic>
#include <functional>
#include <memory>

#include "app/progress.h"
#include "app/session.h"
#include "app/watchdog.h"
#include "engines/distance.h"
#include "engines/solve/solution_source.h"

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
  /// Told why there is no further solution; nothing if an error came.
  using Close = std::function<void(std::optional<Ending> ending)>;

  /// Without any detail of the scene it is not known, either, how much solutions differ.
  Search(const Session& session, const Options& options, Watchdog& watchdog, SceneDetail scene);
  ~Search();
  ExitStatus run(
      const Found& found, const Close& close = [](std::optional<Ending>) {});

  /// Goes on after solutions that an earlier run delivered; they are run again and handed to `seen`. Throws
  /// NotASolution.
  void resume(const std::vector<KnownChoices>& earlier, const Found& seen);

  /// See SolutionSource::times.
  TracingTimes times() const { return series_->times(); }

 private:
  bool wants_more() const { return options_.all || solutions_ < options_.count; }
  Ending deliver_all(const Found& found, Progress& progress);
  std::optional<Solution> next(Progress& progress);
  void deliver(const Solution& solution, const Found& found, Progress& progress);
  void note_diversity(const Solution& solution);
  ExitStatus finish(Ending ending, const Close& close) const;
  ExitStatus status(Ending ending) const;
  void summarize(Ending ending) const;
  void show_progress(Progress& progress, const std::string& more) const;
  void check_mistakes();
  void explain() const;

  const Session& session_;
  const Options& options_;
  Watchdog& watchdog_;
  SceneDetail scene_;
  std::unique_ptr<SolutionSource> series_;
  std::uint64_t resumed_ = 0;            // solutions of earlier runs
  std::uint64_t solutions_ = 0;          // with those of earlier runs; changes only while delivering
  std::uint64_t replays_ = 0;            // times().replays as of the last solution, as the engine is at work
  Diversity diversity_;                  // of all these
  std::optional<Solution> best_so_far_;  // of the search that goes on; changes only while delivering
  /// Given back where there is no more memory, for what is to be done then. It is not touched, so it takes
  /// none from the machine.
  std::unique_ptr<std::byte[]> reserve_ = std::make_unique_for_overwrite<std::byte[]>(std::size_t{32} << 20);
  StopSignal::Clock::time_point start_ = StopSignal::Clock::now();
};

}  // namespace solitaire
