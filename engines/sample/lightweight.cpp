#include "engines/sample/lightweight.h"

#include <algorithm>
#include <cmath>

#include "engines/sample/acceptance.h"

namespace solitaire {

LightweightChain::LightweightChain(const Program& program, const ParamValues& params, const Limits& limits,
                                   std::uint64_t seed, std::uint64_t number, Restarts restarts)
    : stream_(seed, Purpose::kChain, number),
      rerun_(program, params, limits, stream_),
      proposer_(stream_),
      state_(rerun_.start()),
      restarts_(restarts) {
  rerun_.stand_at(state_);
}

void LightweightChain::sweep() {
  if (warming_up_) steps_in_sweep_ = std::max(steps_in_sweep_, state_.choices.size());
  for (std::size_t i = 0; i < steps_in_sweep_; ++i) step();
  if (restarts_.wanted()) restart();
}

void LightweightChain::restart() {
  const double log_ratio = rerun_.restart(proposed_);
  const bool accepted = accepts(log_ratio, stream_.uniform());
  moves_.add(Move::kRestart, accepted);
  restarts_.told(accepted);
  if (accepted) std::swap(state_, proposed_);
  rerun_.stand_at(state_);
}

void LightweightChain::step() {
  if (state_.choices.empty()) return;
  const std::size_t picked = stream_.below(state_.choices.size());
  const MetChoice& choice = state_.choices[picked];
  const AddressId address = choice.address;
  const Proposal proposal = proposer_.propose(address, choice.domain, choice.value);
  const double log_ratio = rerun_.propose(picked, proposal, proposed_);
  if (warming_up_ && proposal.move == Move::kWalk)
    proposer_.learn(address, std::exp(std::min(log_ratio, 0.0)));
  const bool accepted = accepts(log_ratio, stream_.uniform());
  moves_.add(proposal.move, accepted);
  if (!accepted) return;
  std::swap(state_, proposed_);
  rerun_.stand_at(state_);
}

void LightweightChain::end_warmup() {
  warming_up_ = false;
  restarts_.end_warmup();
  moves_.clear();
}

}  // namespace solitaire
