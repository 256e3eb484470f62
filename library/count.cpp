#include <solitaire/count.h>

#include "engines/count/counting.h"
#include "library/engine_options.h"
#include "library/program_state.h"
#include "library/translate.h"

namespace solitaire::api {
namespace {

solitaire::CountOptions counting_of(const CountOptions& options) {
  solitaire::CountOptions counting;
  switch (options.way) {
    case CountOptions::Way::kExactIfSmall:
      break;
    case CountOptions::Way::kExact:
      counting.way = solitaire::CountOptions::Way::kExact;
      break;
    case CountOptions::Way::kApproximate:
      counting.way = solitaire::CountOptions::Way::kApproximate;
      break;
  }
  counting.accuracy.tolerance = options.tolerance;
  counting.accuracy.confidence = options.confidence;
  return counting;
}

}  // namespace

class Counter::State {
 public:
  State(const Program& program, const CountOptions& options)
      : program_(program),
        options_(options),
        counter_(program.state().program, values_of_params(program.state(), program.settings()),
                 engine_options(program, options), counting_of(options)) {}

  std::optional<Count> run(const std::function<void(const std::string&)>& progress) {
    return translated(program_.state().program.sources, [&]() -> std::optional<Count> {
      const auto counted = counter_.run([&](const std::string& what) {
        if (progress) progress(what);
      });
      if (!counted) return std::nullopt;
      const auto kind = counted->estimate ? Count::Kind::kEstimate : Count::Kind::kExact;
      return Count{counted->digits(), counted->log10(), kind, options_.tolerance, options_.confidence};
    });
  }

  Count at_least() const {
    const SolutionCount least = counter_.at_least();
    return {least.digits(), least.log10(), Count::Kind::kAtLeast};
  }

 private:
  Program program_;
  CountOptions options_;
  SolutionCounter counter_;
};

Counter::Counter(const Program& program, const CountOptions& options)
    : state_(std::make_unique<State>(program, options)) {}
Counter::~Counter() = default;
std::optional<Count> Counter::run(const std::function<void(const std::string&)>& progress) {
  return state_->run(progress);
}
Count Counter::at_least() const { return state_->at_least(); }

}  // namespace solitaire::api
