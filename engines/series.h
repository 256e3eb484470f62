#pragma once
#include <atomic>
#include <deque>

#include "engines/distinct.h"
#include "engines/tracing.h"

namespace solitaire {

struct SeriesOptions {
  bool distinct_results = false;  // leave out solutions that look like earlier ones
  /// Start the search anew now and then, from nothing but the solutions so far. Then what comes next depends
  /// on them alone, and not on all that the solver went through.
  bool restarts = true;
};

/// The solutions of a program one after the other, as a user sees them. A series that was interrupted goes on
/// with exactly the solutions that would have come, given those that came: it repeats the search from the
/// last start on.
class Series {
 public:
  Series(const Program& program, ParamValues params, const TracingOptions& tracing,
         const SeriesOptions& options);

  /// Takes up a series after these solutions; returns them, run again. To be called before anything else.
  /// Throws NotASolution, whose message names the one that is none, and Interrupted.
  std::vector<Solution> resume(const std::vector<KnownChoices>& earlier);
  /// Finds again what came since the last start before the series was interrupted. next() does it, too, but
  /// then it counts as a search for one solution. False if a limit came first. Throws Interrupted.
  bool catch_up();
  /// Explores, which is part of the search for the first. Throws Interrupted.
  void explore() { engine_->explore(); }
  /// As TracingEngine::next.
  std::optional<Solution> next();
  void on_improvement(std::function<void(const Solution&)> told);

  Ending ending() const { return engine_->ending(); }
  TracingEngine& engine() { return *engine_; }
  const TracingEngine& engine() const { return *engine_; }
  /// Solutions that were left out because they look like others. May be asked for from another thread.
  std::uint64_t alike() const { return alike_; }

 private:
  void start(std::size_t solutions);
  void keep(KnownChoices solution);
  std::optional<Solution> next_different();

  const Program& program_;
  ParamValues params_;
  TracingOptions tracing_;
  SeriesOptions options_;
  std::unique_ptr<TracingEngine> engine_;
  std::function<void(const Solution&)> told_;
  DistinctResults results_;
  std::vector<KnownChoices> solutions_;
  std::deque<KnownChoices> to_repeat_;  // came already, since the last start
  std::size_t next_start_ = 0;
  std::atomic<std::uint64_t> alike_ = 0;
};

}  // namespace solitaire
