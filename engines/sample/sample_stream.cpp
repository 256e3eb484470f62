#include "engines/sample/sample_stream.h"

#include <cmath>
#include <fmt/format.h>

#include "engines/errors.h"
#include "engines/freeze.h"
#include "engines/sample/state_choices.h"
#include "engines/tuning.h"

namespace solitaire {

SampleStream::SampleStream(const Program& program, ParamValues params, const Limits& limits,
                           std::uint64_t seed)
    : program_(program), params_(std::move(params)), limits_(limits), seed_(seed) {}

void SampleStream::sweep(std::uint64_t times) {
  const Stopwatch watch(times_.solve);
  for (std::uint64_t i = 0; i < times; ++i) {
    if (limits_.stop != nullptr && limits_.stop->stopped()) throw Interrupted{};
    chain_->sweep();
  }
}

std::optional<Solution> SampleStream::next() {
  try {
    if (chain_ == nullptr) {
      chain_ = std::make_unique<ShredChain>(program_, params_, limits_, seed_, 0);
      sweep(tuning::kSceneWarmup);
      chain_->end_warmup();
    }
    sweep(tuning::kSceneSweeps);
    return solution();
  } catch (const Interrupted&) {
    ending_ = Ending::kStopped;
    return std::nullopt;
  }
}

Solution SampleStream::solution() {
  const Stopwatch watch(times_.replay);
  ++times_.replays;
  const SampledState& state = chain_->state();
  StateChoices choices(state);
  AddressTable& addresses = chain_->addresses();
  Execution execution = execute(program_, params_, choices, addresses, limits_);
  double log_density = execution.log_weight - static_cast<double>(execution.cost);
  for (const MetChoice& choice : execution.choices) log_density += choice.domain.log_density(choice.value);
  const double size = 1 + std::abs(state.log_prior) + std::abs(state.log_weight);
  if (execution.rejection ||
      !(std::abs(log_density - state.log_density()) <= tuning::kDensityTolerance * size)) {
    throw InternalError(fmt::format("a sampled execution has the log density {}, and was drawn with {}",
                                    log_density, state.log_density()));
  }
  return solution_of(std::move(execution), addresses);
}

}  // namespace solitaire
