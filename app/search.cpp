#include "app/search.h"

#include <fmt/format.h>

#include "app/console.h"
#include "app/explanation.h"
#include "app/formula.h"
#include "app/report.h"
#include "app/solution_json.h"
#include "engines/count/uniform_series.h"
#include "engines/solve/series.h"

namespace solitaire {
namespace {

/// How long to look for a reason after a search that found nothing, in seconds: as long as the search took,
/// and no less than this.
constexpr double kTimeForReason = 3;

double seconds_since(StopSignal::Clock::time_point start) {
  return std::chrono::duration<double>(StopSignal::Clock::now() - start).count();
}

std::unique_ptr<SolutionSource> source_of(const Session& session, const Options& options, SceneDetail scene) {
  const bool distinct_results = options.distinct == Distinct::kResult;
  TracingOptions tracing = session.tracing_options();
  tracing.scene = scene;
  if (options.sampling == Sampling::kUniform) {
    return std::make_unique<UniformSeries>(session.program(), session.params(), tracing, distinct_results);
  }
  SeriesOptions series;
  series.distinct_results = distinct_results;
  if (!options.all) series.most = options.count;
  if (options.jobs > 1 && series.most != 1) series.workers = session.own_programs(options.jobs);
  return std::make_unique<Series>(session.program(), session.params(), tracing, std::move(series));
}

}  // namespace

Search::Search(const Session& session, const Options& options, Watchdog& watchdog, SceneDetail scene)
    : session_(session),
      options_(options),
      watchdog_(watchdog),
      scene_(scene),
      series_(source_of(session, options, scene)) {}

/// The process ends next, so nobody has to take graphs and solvers apart, which is a tenth of the time of a
/// short run. The list keeps them in sight of leak checkers.
Search::~Search() {
  static auto* const left_to_exit = new std::vector<std::unique_ptr<SolutionSource>>;
  if (!series_->has_threads()) left_to_exit->push_back(std::move(series_));
}

void Search::resume(const std::vector<KnownChoices>& earlier, const Found& seen) {
  for (const Solution& solution : series_->resume(earlier)) {
    seen(++solutions_, solution);
    note_diversity(solution);
  }
  resumed_ = solutions_;
  replays_ = times().replays;
}

ExitStatus Search::run(const Found& found, const Close& close) {
  Progress progress(!options_.quiet);
  const Watchdog::AtLimit at_limit(watchdog_, [&] {
    progress.end();
    if (best_so_far_) deliver(Solution(*best_so_far_), found, progress);
    return finish(Ending::kStopped, close);
  });
  try {
    const Ending ending = deliver_all(found, progress);
    if (options_.formula && ending != Ending::kStopped)
      write_formula(series_->engine_of_rest(), *options_.formula);
    ExitStatus status = kDelivered;
    {
      const auto lock = watchdog_.delivering();
      progress.end();
      status = watchdog_.conclude(finish(ending, close));
    }
    if (ending == Ending::kExhausted && solutions_ == 0 && !options_.quiet) explain();
    return status;
  } catch (const ProgramError& error) {
    const auto lock = watchdog_.delivering();
    progress.end();
    report(error, session_.program().sources);
    close(std::nullopt);
    return watchdog_.conclude(kError);
  } catch (...) {
    const auto lock = watchdog_.delivering();
    progress.end();
    try {
      close(std::nullopt);
    } catch (const std::exception&) {  // the first error is the one to report
    }
    throw;
  }
}

/// Why there is no further solution.
Ending Search::deliver_all(const Found& found, Progress& progress) {
  try {
    if (options_.relax) check_mistakes();
    if (wants_more() && !series_->catch_up()) return series_->ending();
    while (wants_more()) {
      const std::optional<Solution> solution = next(progress);
      if (!solution) return series_->ending();
      const auto lock = watchdog_.delivering();
      replays_ = times().replays;
      deliver(*solution, found, progress);
    }
    return Ending::kNone;
  } catch (const Interrupted&) {
    return Ending::kStopped;
  } catch (const std::bad_alloc&) {
    stop_signal().request(StopReason::kOutOfMemory);
    return Ending::kStopped;
  }
}

void Search::show_progress(Progress& progress, const std::string& more) const {
  progress.update(options_.all ? fmt::format("{} solutions{}", solutions_, more)
                               : fmt::format("{} of {} solutions{}", solutions_, options_.count, more));
}

/// Executions that break asserts may come to mistakes that are none; the others may not.
void Search::check_mistakes() {
  TracingOptions tracing = session_.tracing_options();
  tracing.relax = false;
  TracingEngine(session_.program(), session_.params(), tracing).check_mistakes();
}

void Search::deliver(const Solution& solution, const Found& found, Progress& progress) {
  best_so_far_.reset();
  for (const std::string& line : solution.execution.printed) progress.say(line);
  found(solutions_ + 1, solution);
  ++solutions_;
  note_diversity(solution);
}

void Search::note_diversity(const Solution& solution) {
  if (scene_ != SceneDetail::kNone) diversity_.add(solution);
}

std::optional<Solution> Search::next(Progress& progress) {
  Watchdog::SolutionTime time(watchdog_);
  // A search for the best that has found something ends in good order; see TracingOptions::improvement_time.
  series_->on_improvement([&](const Solution& solution) {
    const auto lock = watchdog_.delivering();
    best_so_far_ = solution;
    show_progress(progress, "; the next so far: " + quality_text(solution));
    time.extend();
  });
  show_progress(progress, "");
  series_->explore();
  show_progress(progress, fmt::format(", graph of {} nodes", series_->engine().graph().size()));
  return series_->next();
}

ExitStatus Search::finish(Ending ending, const Close& close) const {
  if (!options_.quiet) summarize(ending);
  close(ending);
  return status(ending);
}

ExitStatus Search::status(Ending ending) const {
  switch (ending) {
    case Ending::kNone:
      return kDelivered;
    case Ending::kExhausted:
      return options_.all && solutions_ > 0 ? kDelivered : kNoSolution;
    case Ending::kUnexplored:
    case Ending::kWrapped:
    case Ending::kStopped:
      return kLimit;
  }
  return kError;
}

/// Says why there is no solution, if that can be found out soon.
void Search::explain() const {
  const double seconds = std::max(kTimeForReason, seconds_since(start_));
  StopSignal stop(&stop_signal());
  stop.set_deadline(StopSignal::Clock::now() + std::chrono::milliseconds(static_cast<long>(1000 * seconds)));
  TracingOptions tracing = session_.tracing_options();
  tracing.limits.stop = &stop;
  tracing.backend = exact_backend(tracing.backend);
  Explainer explainer(session_.program(), session_.params(), tracing);
  const std::optional<Conflict> conflict = explainer.next_conflict();
  const auto lock = watchdog_.delivering();
  if (conflict) {
    tell(conflict_text(*conflict, {session_.program().sources, explainer.addresses()}));
  } else {
    tell(fmt::format("'solitaire explain {}' looks for the reason\n", options_.script));
  }
}

void Search::summarize(Ending ending) const {
  std::string text =
      fmt::format("{} solution{}{} in {:.2f} s", solutions_, solutions_ == 1 ? "" : "s",
                  resumed_ > 0 ? fmt::format(" ({} of them earlier)", resumed_) : "", seconds_since(start_));
  if (options_.replay == Replay::kEvery) text += fmt::format(", checked by {} runs", replays_);
  if (series_->alike() > 0) text += fmt::format(", not counting {} that look like others", series_->alike());
  switch (ending) {
    case Ending::kNone:
      break;
    case Ending::kExhausted:
      if (solutions_ == 0) {
        text += ": proved that there is none";
      } else if (options_.min_distance > 0) {
        text += ": proved that no other is that far from all of them";
      } else {
        text += ": proved that there is no other";
      }
      break;
    case Ending::kUnexplored:
      text += options_.sampling == Sampling::kUniform
                  ? fmt::format("; {}", kUnexploredText)
                  : "; the paths that were explored have no other. Explore more of them: --explore random:N "
                    "with a larger N, or demand";
      break;
    case Ending::kWrapped:
      text += "; there is no other in 16 bits, which is no proof, since ints can leave them";
      break;
    case Ending::kStopped:
      text += "; " + limit_text(options_);
      break;
  }
  tell(text + "\n");
  if (solutions_ > 1) {
    tell(fmt::format("mean distance of choices {:.2f}, of results {:.2f}\n", diversity_.of_choices(),
                     diversity_.of_results()));
  }
}

}  // namespace solitaire
