#include <fmt/format.h>
#include <optional>
#include <utility>

#include "app/commands.h"
#include "app/console.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/session.h"

namespace solitaire::app {
namespace {

/// Shows an explanation: text as it comes, JSON at the end. The explanation changes only while delivering.
class Shown : public ExplainObserver {
 public:
  Shown(const Options& options, Watchdog& watchdog)
      : options_(options), watchdog_(watchdog), progress_(!options.quiet) {
    explanation_.program = options.script;
  }

  void begun(const std::string& work) override { progress_.update(work); }
  void solutions(bool any) override {
    say(fmt::format("{} has {}\n", options_.script, any ? "solutions" : "no solution"),
        [&] { explanation_.solutions = any; });
  }
  void conflict(const Conflict& conflict) override {
    say(conflict_text(conflict), [&] {
      explanation_.conflicts.push_back(conflict);
      best_.reset();
    });
  }
  void smaller(const Conflict& conflict) override {
    progress_.update(
        fmt::format("{} conditions cannot hold together; looking for fewer", conflict.members.size()));
    const auto lock = watchdog_.delivering();
    best_ = conflict;
  }
  void asserts(const DeadAsserts& asserts) override {
    say(asserts.text, [&] { explanation_.asserts = asserts; });
  }
  void choice(const ReachableValues& choice) override {
    say(choice.text, [&] { explanation_.choices.push_back(choice); });
  }

  /// Shows what is left to show. To be called while delivering.
  ExitStatus finish(Ending ending) {
    progress_.end();
    if (ending == Ending::kStopped && best_) {
      if (!options_.json) print_result(conflict_text(*best_));
      explanation_.conflicts.push_back(*std::exchange(best_, std::nullopt));
    }
    if (ending == Ending::kStopped) tell(fmt::format("{}: {}\n", options_.script, limit_text(options_)));
    if (ending == Ending::kUnexplored)
      tell("there is no solution on the paths that were explored; --explore demand looks at the others\n");
    if (ending == Ending::kExhausted && options_.more > 0 && !options_.json)
      print_result("\nthere is no further conflict that is independent of these\n");
    if (options_.json) print_result(to_json(explanation_) + "\n");
    if (ending != Ending::kNone && ending != Ending::kExhausted) return kLimit;
    return explanation_.solutions == true ? kDelivered : kNoSolution;
  }

 private:
  std::string conflict_text(const Conflict& conflict) const {
    return (explanation_.conflicts.empty() ? "" : "\nindependently, ") +
           (options_.full ? conflict.whole : conflict.text);
  }

  template <class Note>
  void say(const std::string& text, const Note& note) {
    const auto lock = watchdog_.delivering();
    note();
    if (options_.json || text.empty()) return;
    progress_.clear();
    print_result(text);
  }

  const Options& options_;
  Watchdog& watchdog_;
  Progress progress_;
  Explanation explanation_;
  std::optional<Conflict> best_;  // the smallest known, while a smaller one is looked for
};

}  // namespace

/// Says why a program has no solution; and of one that has some, what rules nothing out and what never
/// occurs.
ExitStatus explain_command(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  Shown shown(options, watchdog);
  const Watchdog::AtLimit at_limit(watchdog, [&] { return shown.finish(Ending::kStopped); });
  const ExplainOptions asked{session.search, options.more, options.choices, options.thorough};
  const Ending ending = explain(session.program, asked, shown);
  const auto lock = watchdog.delivering();
  return watchdog.conclude(shown.finish(ending));
}

}  // namespace solitaire::app
