#include "app/search.h"

#include <fmt/format.h>

#include "app/console.h"
#include "app/report.h"

namespace solitaire {
namespace {

std::string reason(Requirement requirement) {
  switch (requirement) {
    case Requirement::kAssert:
      return "the assert fails";
    case Requirement::kLowEnd:
    case Requirement::kHighEnd:
    case Requirement::kStep:
      return "the choice has no value within its range";
    case Requirement::kNotEmpty:
      return "there is nothing to choose from";
    case Requirement::kIndex:
      return "the list has no such element";
    case Requirement::kDivisor:
      return "the divisor is zero";
  }
  return "";
}

}  // namespace

Search::Search(const Session& session, const Options& options, Watchdog& watchdog)
    : session_(session),
      options_(options),
      watchdog_(watchdog),
      engine_(session.program(), session.params(), session.tracing_options()) {}

ExitStatus Search::run(const Found& found, const Close& close) {
  Progress progress(!options_.quiet, options_.all ? 0 : options_.count);
  const Watchdog::AtLimit at_limit(watchdog_, [&] {
    progress.end();
    // The best solution so far of a search for the best would be handed to `found` here, as it was when it
    // was found: the engine goes on meanwhile and must not be asked.
    return finish(Ending::kStopped, close);
  });
  try {
    const Ending ending = deliver_all(found, progress);
    const auto lock = watchdog_.delivering();
    progress.end();
    return watchdog_.conclude(finish(ending, close));
  } catch (const ProgramError& error) {
    const auto lock = watchdog_.delivering();
    progress.end();
    report(error, session_.program().sources);
    close();
    return watchdog_.conclude(kError);
  } catch (...) {
    const auto lock = watchdog_.delivering();
    progress.end();
    try {
      close();
    } catch (const std::exception&) {  // the first error is the one to report
    }
    throw;
  }
}

/// Why there is no further solution.
Ending Search::deliver_all(const Found& found, Progress& progress) {
  try {
    while (wants_more()) {
      const std::optional<Solution> solution = next_different(progress);
      if (!solution) return engine_.ending();
      const auto lock = watchdog_.delivering();
      for (const std::string& line : solution->execution.printed) progress.say(line);
      found(solutions_ + 1, *solution);
      ++solutions_;
    }
    return Ending::kNone;
  } catch (const Interrupted&) {
    return Ending::kStopped;
  } catch (const std::bad_alloc&) {
    reserve_.reset();
    stop_signal().request(StopReason::kOutOfMemory);
    return Ending::kStopped;
  }
}

std::optional<Solution> Search::next_different(Progress& progress) {
  const Watchdog::SolutionTime time(watchdog_);
  engine_.explore();  // which is part of the search for the first
  progress.update(solutions_, engine_.graph().size());
  while (true) {
    std::optional<Solution> solution = engine_.next();
    if (!solution || options_.distinct != Distinct::kResult || results_.add(solution->execution))
      return solution;
    ++alike_;
  }
}

ExitStatus Search::finish(Ending ending, const Close& close) const {
  if (!options_.quiet) summarize(ending);
  close();
  return status(ending);
}

ExitStatus Search::status(Ending ending) const {
  switch (ending) {
    case Ending::kNone:
      return kDelivered;
    case Ending::kExhausted:
      return options_.all && solutions_ > 0 ? kDelivered : kNoSolution;
    case Ending::kUnexplored:
    case Ending::kStopped:
      return kLimit;
  }
  return kError;
}

/// Where every execution ends, if there is such a place: then it alone is why there is no solution.
void Search::explain_dead_end() const {
  for (const TraceAssert& required : engine_.pass().trace.asserts) {
    if (required.guard != kTrue || required.condition != kFalse) continue;
    const std::string what = required.message.empty() ? reason(required.requirement) : required.message;
    const Diagnostic place{required.span, "every execution is ruled out here: " + what, "", {}};
    tell(format(place, session_.program().sources, "note"));
    return;
  }
}

void Search::summarize(Ending ending) const {
  const double seconds = std::chrono::duration<double>(StopSignal::Clock::now() - start_).count();
  std::string text =
      fmt::format("{} solution{} in {:.2f} s", solutions_, solutions_ == 1 ? "" : "s", seconds);
  if (alike_ > 0) text += fmt::format(", not counting {} that look like others", alike_.load());
  switch (ending) {
    case Ending::kNone:
      break;
    case Ending::kExhausted:
      text += solutions_ == 0 ? ": proved that there is none" : ": proved that there is no other";
      break;
    case Ending::kUnexplored:
      text +=
          "; the paths that were explored have no other. Explore more of them: --explore random:N with a "
          "larger N, or demand";
      break;
    case Ending::kStopped:
      text += "; " + limit_text(options_);
      break;
  }
  tell(text + "\n");
  if (ending == Ending::kExhausted && solutions_ == 0) explain_dead_end();
}

}  // namespace solitaire
