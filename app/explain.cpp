#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/explanation.h"
#include "app/report.h"
#include "app/session.h"
#include "app/solution_json.h"

namespace solitaire {
namespace {

using Json = nlohmann::ordered_json;

/// Collects what explain has to say, and prints text as it comes and JSON at the end.
class Explanation {
 public:
  Explanation(const Options& options, const Session& session, Watchdog& watchdog)
      : options_(options), session_(session), watchdog_(watchdog), json_{{"program", options.script}} {}

  void say(const std::string& text) {
    if (options_.json) return;
    const auto lock = watchdog_.delivering();
    print_result(text);
  }
  Json& json() { return json_; }

  /// Why there is no solution.
  ExitStatus conflicts() {
    say(fmt::format("{} has no solution\n", options_.script));
    json_["solutions"] = false;
    json_["conflicts"] = Json::array();
    Explainer explainer(session_.program(), session_.params(), session_.tracing_options());
    const ExplanationContext context{session_.program().sources, explainer.addresses()};
    for (std::uint64_t i = 0; i <= options_.more; ++i) {
      const std::optional<Conflict> conflict = explainer.next_conflict();
      if (!conflict) break;
      say((i == 0 ? "" : "\nindependently, ") + conflict_text(*conflict, context));
      json_["conflicts"].push_back(conflict_json(*conflict, context));
    }
    if (explainer.ending() == Ending::kExhausted && options_.more > 0)
      say("\nthere is no further conflict that is independent of these\n");
    return end(explainer.ending() == Ending::kStopped ? kLimit : kNoSolution);
  }

  /// What is to be known of a program that has solutions.
  ExitStatus possibilities() {
    say(fmt::format("{} has solutions\n", options_.script));
    json_["solutions"] = true;
    const DeadAsserts asserts =
        find_dead_asserts(session_.program(), session_.params(), session_.tracing_options());
    say(dead_text(asserts, session_.program().sources));
    json_["dead"] = dead_json(asserts, session_.program().sources);

    AddressTable addresses;
    const ExplanationContext context{session_.program().sources, addresses};
    const std::vector<ReachableValues> choices =
        find_reachable_values(session_.program(), session_.params(), session_.tracing_options(), addresses);
    bool complete = asserts.complete;
    json_["choices"] = Json::array();
    for (const ReachableValues& choice : choices) {
      complete &= choice.complete;
      if (!options_.choices && (choice.pinned || !choice.restricted())) continue;
      say(values_text(choice, context));
      json_["choices"].push_back(values_json(choice, context));
    }
    return end(complete ? kDelivered : kLimit);
  }

  ExitStatus end(ExitStatus status) {
    const auto lock = watchdog_.delivering();
    if (status == kLimit) tell(fmt::format("{}: {}\n", options_.script, limit_text(options_)));
    if (options_.json) print_result(json_text(json_) + "\n");
    return watchdog_.conclude(status);
  }

 private:
  const Options& options_;
  const Session& session_;
  Watchdog& watchdog_;
  Json json_;
};

}  // namespace

/// Says why a program has no solution; and of one that has some, what rules nothing out and what never
/// occurs.
ExitStatus explain(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  Explanation explanation(options, session, watchdog);
  TracingEngine engine(session.program(), session.params(), session.tracing_options());
  try {
    if (engine.next()) return explanation.possibilities();
  } catch (const ProgramError& error) {
    const auto lock = watchdog.delivering();
    report(error, session.program().sources);
    return watchdog.conclude(kError);
  }
  switch (engine.ending()) {
    case Ending::kExhausted:
      return explanation.conflicts();
    case Ending::kUnexplored:
      explanation.say("no solution on the paths that were explored; --explore demand looks at the others\n");
      [[fallthrough]];
    case Ending::kStopped:
    case Ending::kNone:
      break;
  }
  return explanation.end(kLimit);
}

}  // namespace solitaire
