#include "app/search_summary.h"

#include <fmt/format.h>

#include "app/report.h"
#include "base/counted.h"

namespace solitaire::app {
namespace {

std::string ending_text(const Summary& summary, Ending ending, StopReason reason, const Options& options) {
  switch (ending) {
    case Ending::kNone:
      break;
    case Ending::kExhausted:
      if (summary.solutions == 0) return ": proved that there is none";
      return options.search.min_distance > 0 ? ": proved that no other is that far from all of them"
                                             : ": proved that there is no other";
    case Ending::kUnexplored:
      if (options.search.sampling == Sampling::kUniform) return fmt::format("; {}", kUnexploredText);
      if (options.search.relax && options.search.exploration_name() == "demand")
        return "; there is no other among those that solvers can express, which leaves some out";
      return "; the paths that were explored have no other. Explore more of them: --explore random:N with a "
             "larger N, "
             "or demand";
    case Ending::kWrapped:
      return "; there is no other in 16 bits, which is no proof, since ints can leave them";
    case Ending::kStopped:
      return "; " + limit_text(options, reason);
  }
  return "";
}

}  // namespace

std::string summary_text(const Summary& summary, Ending ending, double seconds, StopReason reason,
                         const Options& options) {
  std::string text =
      fmt::format("{}{} in {:.2f} s", counted(summary.solutions, "solution"),
                  summary.earlier > 0 ? fmt::format(" ({} of them earlier)", summary.earlier) : "", seconds);
  if (const auto runs = summary.times.replays; options.search.run_each && runs > 0)
    text += ", checked by " + counted(runs, "run");
  const bool names_only = summary.names_differed && options.search.distinct == Distinct::kResult;
  if (summary.alike > 0) {
    text += fmt::format(
        ", not counting {} that {}{}", summary.alike,
        options.search.distinct == Distinct::kValue ? "have the value of others" : "look like others",
        names_only ? " but for names or extras" : "");
  } else if (names_only) {
    text += ", not counting those that differ in names or extras only";
  }
  text += ending_text(summary, ending, reason, options) + "\n";
  if (summary.solutions > 1) {
    const bool of_pairs = summary.solutions > 2 && summary.nearest_choices;
    text += fmt::format("mean distance of choices {:.2f}{}, of results {:.2f}\n", summary.choice_distance,
                        of_pairs ? fmt::format(" (nearest two {:.2f})", *summary.nearest_choices) : "",
                        summary.result_distance);
  }
  return text;
}

ExitStatus status_of(const Summary& summary, Ending ending, const Options& options) {
  switch (ending) {
    case Ending::kNone:
      return kDelivered;
    case Ending::kExhausted:
      return options.search.all && summary.solutions > 0 ? kDelivered : kNoSolution;
    case Ending::kUnexplored:
    case Ending::kWrapped:
    case Ending::kStopped:
      break;
  }
  return kLimit;
}

}  // namespace solitaire::app
