#include "engines/sample/lightweight.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "engines/sample/impossible.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

}  // namespace

/// Answers as the present state does, but for one choice that is changed.
class LightweightChain::Answers : public Choices {
 public:
  Answers(LightweightChain& chain, AddressId changed, TypedScalar value)
      : chain_(chain), changed_(changed), value_(value) {
    chain_.met_.assign(chain_.state_.choices.size(), false);
  }

  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    const std::uint32_t position = chain_.position(address);
    if (position == kNowhere) return drawn(domain);
    chain_.met_[position] = true;
    const TypedScalar known = address == changed_ ? value_ : chain_.state_.choices[position].value;
    if (known.type() == domain.type()) return known;
    possible_ = false;  // another choice has that address now, for which the value is none
    return domain.sample(chain_.stream_);
  }
  bool weighs() const override { return true; }

  /// The logarithm of the density of all that was drawn.
  double drawn_density() const { return drawn_density_; }
  bool possible() const { return possible_; }

 private:
  std::optional<TypedScalar> drawn(const Distribution& domain) {
    const TypedScalar value = domain.sample(chain_.stream_);
    drawn_density_ += domain.log_density(value);
    return value;
  }

  LightweightChain& chain_;
  AddressId changed_;
  TypedScalar value_;
  double drawn_density_ = 0;
  bool possible_ = true;
};

LightweightChain::LightweightChain(const Program& program, const ParamValues& params, const Limits& limits,
                                   std::uint64_t seed, std::uint64_t number)
    : program_(program),
      executor_(program, params, addresses_, limits),
      stream_(seed, Purpose::kChain, number),
      proposer_(stream_) {
  start();
}

void LightweightChain::start() {
  for (std::uint64_t i = 0; i < tuning::kMostStarts; ++i) {
    Answers answers(*this, AddressTable::root(), {});
    Execution& execution = executor_.run(answers);
    const std::optional<Rejection> rejection = execution.rejection;
    take(execution, state_);
    if (state_.log_density() > kImpossible) return set_positions();
    if (i + 1 == tuning::kMostStarts) throw no_start(rejection);
    state_ = {};
  }
}

void LightweightChain::take(Execution& execution, State& state) const {
  std::swap(state.choices, execution.choices);
  state.log_priors.clear();
  state.log_prior = 0;
  for (const MetChoice& choice : state.choices) {
    state.log_priors.push_back(choice.domain.log_density(choice.value));
    state.log_prior += state.log_priors.back();
  }
  state.log_weight = execution.log_weight - static_cast<double>(execution.cost);
  if (execution.rejection || std::isnan(state.log_density())) state.log_weight = kImpossible;
  state.value = std::move(execution.value);
}

void LightweightChain::set_positions() {
  positions_.assign(addresses_.size(), kNowhere);
  for (std::uint32_t i = 0; i < state_.choices.size(); ++i) positions_[state_.choices[i].address.index] = i;
}

/// The logarithm of the density with which a step back would draw what this one forgets.
double LightweightChain::forgotten() const {
  double sum = 0;
  for (std::size_t i = 0; i < met_.size(); ++i)
    if (!met_[i]) sum += state_.log_priors[i];
  return sum;
}

void LightweightChain::sweep() {
  if (warming_up_) steps_in_sweep_ = std::max(steps_in_sweep_, state_.choices.size());
  for (std::size_t i = 0; i < steps_in_sweep_; ++i) step();
}

/// The ratio of densities, times that of the ways back and forth: which choice is picked, one of n against
/// one of n'; which value it gets; and which values are drawn anew, there and back.
void LightweightChain::step() {
  if (state_.choices.empty()) return;
  const auto count = static_cast<double>(state_.choices.size());
  const MetChoice picked = state_.choices[stream_.below(state_.choices.size())];
  const Proposal proposal = proposer_.propose(picked.address, picked.domain, picked.value);
  MoveCount& moves = moves_[name(proposal.move)];
  ++moves.tried;
  double log_ratio = kImpossible;
  if (picked.domain.contains(proposal.value)) {
    Answers answers(*this, picked.address, proposal.value);
    take(executor_.run(answers), proposed_);
    if (answers.possible() && proposed_.log_density() > kImpossible) {
      log_ratio = proposed_.log_density() - state_.log_density() + proposal.log_ratio + forgotten() -
                  answers.drawn_density() + std::log(count) -
                  std::log(static_cast<double>(proposed_.choices.size()));
    }
  }
  if (warming_up_ && proposal.move == Proposal::Move::kWalk)
    proposer_.learn(picked.address, std::exp(std::min(log_ratio, 0.0)));
  if (!(std::log(stream_.uniform()) < log_ratio)) return;
  std::swap(state_, proposed_);
  set_positions();
  ++moves.accepted;
}

void LightweightChain::end_warmup() {
  warming_up_ = false;
  moves_.clear();
}

}  // namespace solitaire
