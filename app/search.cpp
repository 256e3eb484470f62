#include "app/search.h"

#include <fmt/format.h>

#include "app/progress.h"

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

Search::Search(const Session& session, const Options& options)
    : session_(session),
      options_(options),
      engine_(session.program(), session.params(), session.tracing_options()) {}

ExitStatus Search::run(const Found& found) {
  {
    Progress progress(!options_.quiet, options_.all ? 0 : options_.count);
    try {
      engine_.explore();
      progress.update(0, engine_.graph().size());
      while (wants_more()) {
        const std::optional<Solution> solution = engine_.next();
        if (!solution) break;
        if (options_.distinct == Distinct::kResult && !results_.add(solution->execution)) {
          ++alike_;
          continue;
        }
        ++solutions_;
        for (const std::string& line : solution->execution.printed) progress.say(line);
        found(solutions_, *solution);
        progress.update(solutions_, engine_.graph().size());
      }
    } catch (const ProgramError& error) {
      progress.clear();
      report(error, session_.program().sources);
      return kError;
    }
  }
  if (!options_.quiet) summarize();
  return status();
}

ExitStatus Search::status() const {
  switch (engine_.ending()) {
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
    fmt::print(stderr, "{}", format(place, session_.program().sources, "note"));
    return;
  }
}

void Search::summarize() const {
  const double seconds = std::chrono::duration<double>(StopSignal::Clock::now() - start_).count();
  std::string text =
      fmt::format("{} solution{} in {:.2f} s", solutions_, solutions_ == 1 ? "" : "s", seconds);
  if (alike_ > 0) text += fmt::format(", not counting {} that look like others", alike_);
  switch (engine_.ending()) {
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
      text += stop_signal().requested() ? "; interrupted" : "; the time limit came first";
      break;
  }
  fmt::print(stderr, "{}\n", text);
  if (engine_.ending() == Ending::kExhausted && solutions_ == 0) explain_dead_end();
}

}  // namespace solitaire
