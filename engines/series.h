#pragma once
#include <atomic>
#include <deque>

#include "engines/distinct.h"
#include "engines/solution_source.h"

namespace solitaire {

struct SeriesOptions {
  bool distinct_results = false;  // leave out solutions that look like earlier ones
  /// Start the search anew now and then, from nothing but the solutions so far. Then what comes next depends
  /// on them alone, and not on all that the solver went through.
  bool restarts = true;
};

/// The solutions that a TracingEngine finds. A series that was interrupted repeats the search from the last
/// start on.
class Series : public SolutionSource {
 public:
  Series(const Program& program, ParamValues params, const TracingOptions& tracing,
         const SeriesOptions& options);

  std::vector<Solution> resume(const std::vector<KnownChoices>& earlier) override;
  /// Finds again what came since the last start before the series was interrupted.
  bool catch_up() override;
  void explore() override { engine_->explore(); }
  std::optional<Solution> next() override;
  void on_improvement(std::function<void(const Solution&)> told) override;

  Ending ending() const override { return engine_->ending(); }
  TracingEngine& engine() override { return *engine_; }
  const TracingEngine& engine() const override { return *engine_; }
  std::uint64_t alike() const override { return alike_; }

 private:
  void start(std::size_t solutions);
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
