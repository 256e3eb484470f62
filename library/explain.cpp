#include <mutex>
#include <solitaire/explain.h>

#include "engines/solve/tracing.h"
#include "library/endings.h"
#include "library/engine_options.h"
#include "library/explanation.h"
#include "library/program_state.h"
#include "library/translate.h"

namespace solitaire::api {
namespace {

/// Conflicts of the search that a single question about a program with solutions is worth: parts of a second.
constexpr std::uint64_t kEffort = 5000;

/// A program whose questions are asked.
struct Questions {
  Questions(const Program& program_to_ask, const ExplainOptions& explain_options)
      : program(program_to_ask),
        options(explain_options),
        parsed(program.state().program),
        params(values_of_params(program.state(), program.settings())),
        engine(engine_options(program, options)) {}

  const Program& program;
  const ExplainOptions& options;
  const solitaire::Program& parsed;
  ParamValues params;
  TracingOptions engine;
};

Ending tell_conflicts(const Questions& asked, ExplainObserver& observer) {
  observer.begun("looking for conditions that cannot hold together");
  Explainer explainer(asked.program, asked.options, asked.options.thorough);
  explainer.observe(&observer);
  for (std::uint64_t i = 0; i <= asked.options.more; ++i) {
    const std::optional<Conflict> conflict = explainer.next();
    if (!conflict) break;
    observer.conflict(*conflict);
  }
  return explainer.ending();
}

Ending tell_possibilities(const Questions& asked, ExplainObserver& observer) {
  TracingOptions engine = asked.engine;
  engine.effort = asked.options.thorough ? 0 : kEffort;
  observer.begun("looking for asserts that rule nothing out");
  observer.asserts(frozen(find_dead_asserts(asked.parsed, asked.params, engine), asked.parsed.sources));
  observer.begun("looking for values that never occur");
  AddressTable addresses;
  find_reachable_values(asked.parsed, asked.params, engine, addresses, asked.options.all_choices,
                        [&](const solitaire::ReachableValues& choice) {
                          const bool telling = !choice.pinned && choice.restricted();
                          if (telling || asked.options.all_choices)
                            observer.choice(frozen(choice, addresses));
                        });
  return asked.options.stop.stopped() ? Ending::kStopped : Ending::kNone;
}

}  // namespace

ExplainObserver::~ExplainObserver() = default;

class Explainer::State {
 public:
  State(const Program& program, const Options& options, bool thorough)
      : program_(program),
        stop_(options.stop),
        explainer_(program.state().program, values_of_params(program.state(), program.settings()),
                   engine_options(program, options).exact(), thorough) {
    explainer_.on_smaller([this](const solitaire::Conflict& conflict) { keep(conflict); });
  }

  std::optional<Conflict> next() {
    return translated(sources(), [&]() -> std::optional<Conflict> {
      const std::optional<solitaire::Conflict> conflict = explainer_.next_conflict();
      const std::lock_guard lock(mutex_);
      best_.reset();
      if (!conflict) return std::nullopt;
      return frozen(*conflict, {sources(), explainer_.addresses()});
    });
  }

  std::optional<Conflict> best_so_far() const {
    const std::lock_guard lock(mutex_);
    return best_;
  }

  void observe(ExplainObserver* observer) { observer_ = observer; }
  Ending ending() const { return public_ending(explainer_.ending()); }

 private:
  const SourceSet& sources() const { return program_.state().program.sources; }

  void keep(const solitaire::Conflict& conflict) {
    Conflict made = frozen(conflict, {sources(), explainer_.addresses()});
    if (observer_ != nullptr) observer_->smaller(made);
    const std::lock_guard lock(mutex_);
    best_ = std::move(made);
  }

  Program program_;
  StopToken stop_;  // keeps alive what the engine looks at
  solitaire::Explainer explainer_;
  ExplainObserver* observer_ = nullptr;
  mutable std::mutex mutex_;  // guards best_
  std::optional<Conflict> best_;
};

Explainer::Explainer(const Program& program, const Options& options, bool thorough)
    : state_(std::make_unique<State>(program, options, thorough)) {}
Explainer::~Explainer() = default;
std::optional<Conflict> Explainer::next() { return state_->next(); }
Ending Explainer::ending() const { return state_->ending(); }
std::optional<Conflict> Explainer::best_so_far() const { return state_->best_so_far(); }
void Explainer::observe(ExplainObserver* observer) { state_->observe(observer); }

Ending explain(const Program& program, const ExplainOptions& options, ExplainObserver& observer) {
  const Questions asked(program, options);
  return translated(asked.parsed.sources, [&] {
    observer.begun("looking for a solution");
    TracingEngine engine(asked.parsed, asked.params, asked.engine);
    const bool any = engine.next().has_value();
    if (!any && engine.ending() != solitaire::Ending::kExhausted) return public_ending(engine.ending());
    observer.solutions(any);
    return any ? tell_possibilities(asked, observer) : tell_conflicts(asked, observer);
  });
}

}  // namespace solitaire::api
