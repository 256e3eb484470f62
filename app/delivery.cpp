#include "app/delivery.h"

#include <fmt/format.h>
#include <unistd.h>

#include "app/console.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/search_summary.h"
#include "app/signals.h"

namespace solitaire::app {
namespace {

/// After a search that found nothing, a reason is looked for so many seconds: a share of the time that the
/// search took, and at least this.
constexpr double kTimeForReason = 3;
constexpr double kShareForReason = 0.5;

class Delivery : public SearchObserver {
 public:
  Delivery(Search& search, const Session& session, const Options& options, Watchdog& watchdog,
           const Found& found, const Close& close)
      : search_(search),
        session_(session),
        options_(options),
        watchdog_(watchdog),
        found_(found),
        close_(close),
        progress_(!options.quiet) {
    search_.observe(this);
  }
  ~Delivery() override { search_.observe(nullptr); }
  Delivery(const Delivery&) = delete;
  Delivery& operator=(const Delivery&) = delete;

  ExitStatus run() {
    const Watchdog::AtLimit at_limit(
        watchdog_, [this] { return end_at_limit(); }, search_.stop_token());
    try {
      const Ending ending = deliver();
      if (options_.formula && ending != Ending::kStopped) search_.write_formula(*options_.formula);
      const bool asks_why =
          ending == Ending::kExhausted && search_.summary().solutions == 0 && !options_.quiet;
      return asks_why ? explain(summarize(ending)) : conclude(ending);
    } catch (...) {
      close_after_error();
      throw;
    }
  }

  void begun() override { show_progress(""); }
  void explored(std::size_t nodes) override { show_progress(fmt::format(", graph of {} nodes", nodes)); }
  void improved(const Solution& best) override { show_progress("; the next so far: " + quality_text(best)); }

 private:
  /// Returns why there is no further solution.
  Ending deliver() {
    try {
      while (const std::optional<Solution> solution = search_.next()) {
        const auto lock = watchdog_.delivering();
        hand_over(*solution);
      }
      return search_.ending();
    } catch (const std::bad_alloc&) {
      reserve_.reset();
      stop_source().request(StopReason::kOutOfMemory);
      return Ending::kStopped;
    } catch (const Error& error) {
      if (error.kind() != Error::Kind::kStopped) throw;
      return Ending::kStopped;
    }
  }

  void hand_over(const Solution& solution) {
    for (const std::string& line : solution.printed) progress_.say(line);
    found_(solution);
    delivered_ = search_.summary();
  }

  ExitStatus conclude(Ending ending) {
    const auto lock = watchdog_.delivering();
    progress_.end();
    return watchdog_.conclude(finish(ending));
  }

  /// What conclude() does, before more is done.
  ExitStatus summarize(Ending ending) {
    const auto lock = watchdog_.delivering();
    progress_.clear();
    return finish(ending);
  }

  ExitStatus end_at_limit() {
    progress_.end();
    if (const auto best = search_.take_best_so_far()) hand_over(*best);
    return finish(Ending::kStopped);
  }

  ExitStatus finish(Ending ending) {
    Summary summary = delivered_;
    summary.alike = search_.summary().alike;
    summary.names_differed = search_.summary().names_differed;
    if (!options_.quiet)
      tell(summary_text(summary, ending, seconds(), search_.stop_token().reason(), options_));
    close_(ending);
    return status_of(summary, ending, options_);
  }

  void close_after_error() {
    const auto lock = watchdog_.delivering();
    progress_.end();
    try {
      close_(std::nullopt);
    } catch (const std::exception&) {  // the first error is the one to report
    }
  }

  void show_progress(const std::string& more) {
    const std::uint64_t solutions = search_.summary().solutions;
    progress_.update(options_.search.all
                         ? fmt::format("{} solutions{}", solutions, more)
                         : fmt::format("{} of {} solutions{}", solutions, options_.search.count, more));
  }

  /// Says why there is no solution, as far as that can be found out soon, and returns the search's status.
  ExitStatus explain(ExitStatus status) {
    const auto time = std::chrono::duration<double>(std::max(kTimeForReason, kShareForReason * seconds()));
    const StopSource stop(session_.search.stop);
    stop.set_deadline(Clock::now() + std::chrono::duration_cast<Clock::duration>(time));
    SearchOptions asked = session_.search;
    asked.stop = stop.token();
    progress_.update("looking for the reason");
    Explainer explainer(session_.program, asked);
    const auto tell_best = [&] {
      tell_reason(explainer.best_so_far());
      return status;
    };
    const Watchdog::AtLimit at_limit(watchdog_, tell_best, stop.token());
    const std::optional<Conflict> conflict = explainer.next();
    const auto lock = watchdog_.delivering();
    tell_reason(conflict);
    return watchdog_.conclude(status);
  }

  void tell_reason(const std::optional<Conflict>& conflict) {
    progress_.end();
    tell(conflict ? conflict->text
                  : fmt::format(
                        "'solitaire explain {}', with the same params and pins, takes the time to find the "
                        "reason\n",
                        options_.script));
  }

  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  Search& search_;
  const Session& session_;
  const Options& options_;
  Watchdog& watchdog_;
  const Found& found_;
  const Close& close_;
  Progress progress_;
  Summary delivered_ = search_.summary();  // changes only while delivering
  /// Given back where there is no more memory, for what is to be done then. It is not touched, so it takes
  /// none from the machine.
  std::unique_ptr<std::byte[]> reserve_ = std::make_unique_for_overwrite<std::byte[]>(std::size_t{32} << 20);
  Clock::time_point start_ = Clock::now();
};

}  // namespace

void deliver_all(Search& search, const Session& session, const Options& options, Watchdog& watchdog,
                 const Found& found, const Close& close) {
  const ExitStatus status = Delivery(search, session, options, watchdog, found, close).run();
  ::_exit(status);
}

}  // namespace solitaire::app
