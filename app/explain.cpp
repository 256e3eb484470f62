#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/console.h"
#include "app/explanation.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/session.h"
#include "app/signals.h"
#include "app/solution_json.h"

namespace solitaire {
namespace {

using Json = nlohmann::ordered_json;

/// Conflicts of the search that a single question about a program with solutions is worth: parts of a second.
constexpr std::uint64_t kEffort = 5000;

/// What explain has to say: text as it comes, JSON at the end. It changes only while delivering.
class Explanation {
 public:
  Explanation(const Options& options, const Session& session, Watchdog& watchdog)
      : options_(options),
        session_(session),
        watchdog_(watchdog),
        progress_(!options.quiet),
        json_{{"program", options.script}} {
    progress_.update("looking for a solution");
  }

  /// Why there is no solution.
  ExitStatus conflicts() {
    say(fmt::format("{} has no solution\n", options_.script), [](Json& json) {
      json["solutions"] = false;
      json["conflicts"] = Json::array();
    });
    progress_.update("looking for conditions that cannot hold together");
    Explainer explainer(session_.program(), session_.params(), session_.tracing_options());
    const ExplanationContext context{session_.program().sources, explainer.addresses()};
    for (std::uint64_t i = 0; i <= options_.more; ++i) {
      const std::optional<Conflict> conflict = explainer.next_conflict();
      if (!conflict) break;
      say((i == 0 ? "" : "\nindependently, ") + conflict_text(*conflict, context),
          [&](Json& json) { json["conflicts"].push_back(conflict_json(*conflict, context)); });
    }
    if (explainer.ending() == Ending::kExhausted && options_.more > 0)
      say("\nthere is no further conflict that is independent of these\n", [](Json&) {});
    return conclude(explainer.ending() == Ending::kStopped ? kLimit : kNoSolution);
  }

  /// What is to be known of a program that has solutions.
  ExitStatus possibilities() {
    say(fmt::format("{} has solutions\n", options_.script), [](Json& json) { json["solutions"] = true; });
    TracingOptions tracing = session_.tracing_options();
    tracing.effort = options_.thorough ? 0 : kEffort;
    progress_.update("looking for asserts that rule nothing out");
    const DeadAsserts asserts = find_dead_asserts(session_.program(), session_.params(), tracing);
    say(dead_text(asserts, session_.program().sources), [&](Json& json) {
      json["dead"] = dead_json(asserts, session_.program().sources);
      json["undecided"] = asserts.undecided;
      json["choices"] = Json::array();
    });
    progress_.update("looking for values that never occur");
    AddressTable addresses;
    const ExplanationContext context{session_.program().sources, addresses};
    find_reachable_values(session_.program(), session_.params(), tracing, addresses,
                          [&](const ReachableValues& choice) {
                            if (!options_.choices && (choice.pinned || !choice.restricted())) return;
                            say(values_text(choice, context),
                                [&](Json& json) { json["choices"].push_back(values_json(choice, context)); });
                          });
    return conclude(stop_signal().stopped() ? kLimit : kDelivered);
  }

  ExitStatus conclude(ExitStatus status) {
    const auto lock = watchdog_.delivering();
    return watchdog_.conclude(finish(status));
  }

  void end_progress() { progress_.end(); }

  /// To be called while delivering.
  ExitStatus finish(ExitStatus status) {
    progress_.end();
    if (status == kLimit) tell(fmt::format("{}: {}\n", options_.script, limit_text(options_)));
    if (options_.json) print_result(json_text(json_) + "\n");
    return status;
  }

 private:
  template <class Note>
  void say(const std::string& text, const Note& note) {
    const auto lock = watchdog_.delivering();
    note(json_);
    if (!options_.json && !text.empty()) {
      progress_.clear();
      print_result(text);
    }
  }

  const Options& options_;
  const Session& session_;
  Watchdog& watchdog_;
  Progress progress_;
  Json json_;
};

}  // namespace

/// Says why a program has no solution; and of one that has some, what rules nothing out and what never
/// occurs.
ExitStatus explain(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  Explanation explanation(options, session, watchdog);
  const Watchdog::AtLimit at_limit(watchdog, [&] { return explanation.finish(kLimit); });
  TracingEngine engine(session.program(), session.params(), session.tracing_options());
  try {
    if (engine.next()) return explanation.possibilities();
  } catch (const ProgramError& error) {
    const auto lock = watchdog.delivering();
    explanation.end_progress();
    report(error, session.program().sources);
    return watchdog.conclude(kError);
  }
  if (engine.ending() == Ending::kExhausted) return explanation.conflicts();
  if (engine.ending() == Ending::kUnexplored)
    tell("there is no solution on the paths that were explored; --explore demand looks at the others\n");
  return explanation.conclude(kLimit);
}

}  // namespace solitaire
