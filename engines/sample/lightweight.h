#pragma once
#include "engines/sample/chain.h"
#include "engines/sample/rerun.h"
#include "engines/sample/restarts.h"
#include "solitaire/value/plain_copy.h"

namespace solitaire {

/// Metropolis-Hastings by running the program again for each step. It can do all that the language can, and
/// is what other engines are held against.
class LightweightChain : public Chain {
 public:
  /// The program and the params have to outlive the chain. Throws ProgramError if no possible execution is
  /// drawn to start with.
  LightweightChain(const Program& program, const ParamValues& params, const Limits& limits,
                   std::uint64_t seed, std::uint64_t number, Restarts restarts = Restarts());

  void sweep() override;
  void end_warmup() override;
  void read(const ReturnedNumbers& returned, std::vector<std::string>& names,
            std::vector<double>& numbers) override {
    returned.read(plain(state_.value), names, numbers);
  }
  MoveCounts moves() const override { return moves_.named(); }
  Troubles troubles() const override { return {0, 0, rerun_.infinities()}; }

 private:
  void step();
  void restart();

  RandomStream stream_;
  Rerun rerun_;
  Proposer proposer_;
  SampledState state_;
  SampledState proposed_;
  std::size_t steps_in_sweep_ = 1;  // the most choices that a state of the warm-up had
  Restarts restarts_;
  bool warming_up_ = true;
  MoveTally moves_;
};

}  // namespace solitaire
