#pragma once
#include <vector>

#include "engines/sample/chain.h"
#include "engines/sample/proposal.h"
#include "solitaire/run/evaluator.h"
#include "solitaire/value/plain_copy.h"

namespace solitaire {

/// Metropolis-Hastings by running the program again (Wingate, Stuhlmueller and Goodman 2011; section 2.3 of
/// the dissertation). A step changes one choice and runs the program with all others as they were, found by
/// their addresses. Choices that are met for the first time are drawn from their distributions, and those not
/// met any more are forgotten. It can do all that the language can, and is what other engines are held
/// against.
class LightweightChain : public Chain {
 public:
  /// The program has to outlive the chain. Throws ProgramError if no possible execution is drawn to start
  /// with.
  LightweightChain(const Program& program, const ParamValues& params, const Limits& limits,
                   std::uint64_t seed, std::uint64_t number);

  void sweep() override;
  void end_warmup() override;
  PlainValue value() override { return plain(state_.value); }
  const MoveCounts& moves() const override { return moves_; }

  /// One step.
  void step();
  /// The present state's choices and the logarithm of its density, for tests.
  const std::vector<MetChoice>& choices() const { return state_.choices; }
  double log_density() const { return state_.log_density(); }

 private:
  static constexpr std::uint32_t kNowhere = UINT32_MAX;
  struct State {
    std::vector<MetChoice> choices;
    std::vector<double> log_priors;  // one for each choice
    double log_prior = 0;            // their sum
    double log_weight = 0;           // of factors and wishes; minus infinity where it is ruled out
    Value value;

    double log_density() const { return log_prior + log_weight; }
  };
  class Answers;

  void start();
  void take(Execution& execution, State& state) const;
  void set_positions();
  double forgotten() const;
  std::uint32_t position(AddressId address) const {
    return address.index < positions_.size() ? positions_[address.index] : kNowhere;
  }

  const Program& program_;
  AddressTable addresses_;
  Executor executor_;
  RandomStream stream_;
  Proposer proposer_;
  State state_;
  State proposed_;
  std::vector<std::uint32_t> positions_;  // in state_.choices, by address number
  std::vector<bool> met_;                 // of the present choices, by the proposed execution
  std::size_t steps_in_sweep_ = 1;        // the most choices that a state of the warm-up had
  bool warming_up_ = true;
  MoveCounts moves_;
};

}  // namespace solitaire
