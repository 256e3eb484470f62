#pragma once
#include <optional>
#include <vector>

#include "engines/sample/fresh_values.h"
#include "engines/sample/proposal.h"
#include "engines/sample/sampled_state.h"
#include "solitaire/run/evaluator.h"

namespace solitaire {

/// Changes one choice of an execution by running the program again (Wingate, Stuhlmueller and Goodman 2011;
/// section 2.3 of the dissertation). All other choices stay as they were, found by their addresses. Choices
/// that are met for the first time are drawn from their distributions, and those not met any more are
/// forgotten.
class Rerun {
 public:
  /// The program, the params and the stream have to outlive it.
  Rerun(const Program& program, const ParamValues& params, const Limits& limits, RandomStream& stream);

  /// Draws executions from the distributions, and returns the one that explains best what is observed of a
  /// few that are possible. If none is drawn, a solver looks for one; throws ProgramError if it finds none.
  SampledState start();
  /// The state that is changed from now on, which has to stay where it is. To be called again after
  /// restart().
  void stand_at(const SampledState& state);
  /// Proposes the execution in which a choice of the state, by its number, has another value. Returns the
  /// logarithm of the ratio by which it is accepted: that of the densities, times that of the ways there and
  /// back. It is minus infinity where the execution is impossible; then `proposed` is of no use.
  double propose(std::size_t picked, const Proposal& proposal, SampledState& proposed);

  /// Proposes another execution, all of whose choices are drawn anew, and returns the same.
  double restart(SampledState& proposed);
  /// Runs the execution of the state as it is.
  void repeat(SampledState& repeated);

  AddressTable& addresses() { return addresses_; }
  /// Those that propose() and restart() draw, and then clear.
  FreshValues& fresh_values() { return fresh_values_; }
  /// How often the density was infinite, which counts as impossible: no distribution has such a value.
  std::uint64_t infinities() const { return infinities_; }

 private:
  class Answers;
  static constexpr std::uint32_t kNowhere = UINT32_MAX;

  bool draw(SampledState& state, std::optional<Span>& ruled_out);
  std::optional<SampledState> solve();
  void take(Execution& execution, SampledState& state);
  double forgotten() const;
  std::uint32_t position(AddressId address) const {
    return address.index < positions_.size() ? positions_[address.index] : kNowhere;
  }

  const Program& program_;
  const ParamValues& params_;
  Limits limits_;
  AddressTable addresses_;
  Executor executor_;
  RandomStream& stream_;
  FreshValues fresh_values_;
  const SampledState* state_ = nullptr;
  std::vector<std::uint32_t> positions_;  // in the state's choices, by address number
  std::vector<bool> met_;                 // of the state's choices, by the proposed execution
  std::uint64_t infinities_ = 0;
};

}  // namespace solitaire
