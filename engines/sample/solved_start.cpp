#include "engines/sample/solved_start.h"

#include "engines/solve/tracing.h"

namespace solitaire {

std::optional<ChosenValues> solved_start(const Program& program, const ParamValues& params,
                                         const Limits& limits, std::uint64_t seed) {
  TracingOptions options;
  options.seed = seed;
  options.scene = SceneDetail::kNone;
  options.limits = limits;
  try {
    TracingEngine engine(program, params, options);
    std::optional<Solution> solution = engine.next();
    if (!solution) return std::nullopt;
    ChosenValues choices = std::move(solution->choices);
    choices.insert(choices.end(), solution->auxiliary.begin(), solution->auxiliary.end());
    return choices;
  } catch (const ProgramError&) {
    return std::nullopt;
  }
}

}  // namespace solitaire
