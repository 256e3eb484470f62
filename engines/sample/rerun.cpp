#include "engines/sample/rerun.h"

#include <cmath>
#include <limits>

#include "engines/sample/impossible.h"
#include "engines/sample/solved_start.h"
#include "engines/sample/state_choices.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

}  // namespace

/// Answers as a state does, but for one choice that is changed.
class Rerun::Answers : public Choices {
 public:
  explicit Answers(Rerun& rerun) : rerun_(rerun) {
    rerun_.met_.assign(rerun_.state_ == nullptr ? 0 : rerun_.state_->choices.size(), false);
  }
  void change(std::uint32_t position, TypedScalar value) {
    changed_ = position;
    value_ = value;
  }

  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    const std::uint32_t position = rerun_.position(address);
    if (position == kNowhere) return drawn(address, domain);
    rerun_.met_[position] = true;
    const TypedScalar known = position == changed_ ? value_ : rerun_.state_->choices[position].value;
    if (known.type() == domain.type()) return known;
    possible_ = false;  // another choice has that address now, for which the value is none
    return domain.sample(rerun_.stream_);
  }
  bool weighs() const override { return true; }

  /// The logarithm of the density of all that was drawn.
  double drawn_density() const { return drawn_density_; }
  bool possible() const { return possible_; }

 private:
  TypedScalar drawn(AddressId address, const Distribution& domain) {
    const TypedScalar value = rerun_.fresh_values_.draw(address, domain);
    drawn_density_ += domain.log_density(value);
    return value;
  }

  Rerun& rerun_;
  std::uint32_t changed_ = kNowhere;
  TypedScalar value_;
  double drawn_density_ = 0;
  bool possible_ = true;
};

Rerun::Rerun(const Program& program, const ParamValues& params, const Limits& limits, RandomStream& stream)
    : program_(program),
      params_(params),
      limits_(limits),
      executor_(program, params, addresses_, limits),
      stream_(stream),
      fresh_values_(stream) {}

SampledState Rerun::start() {
  std::optional<Span> ruled_out;
  SampledState best;
  best.log_weight = kImpossible;
  std::size_t possible = 0;
  for (std::uint64_t i = 0; i < tuning::kMostStarts && possible < tuning::kStartsCompared; ++i) {
    SampledState state;
    if (!draw(state, ruled_out)) continue;
    ++possible;
    if (state.log_weight > best.log_weight) best = std::move(state);
  }
  if (possible > 0) return best;
  if (std::optional<SampledState> solved = solve()) return std::move(*solved);
  throw no_start(ruled_out);
}

/// The stream says which solution it is, so that chains start from different ones.
std::optional<SampledState> Rerun::solve() {
  const std::optional<ChosenValues> found = solved_start(program_, params_, limits_, stream_.next());
  if (!found) return std::nullopt;
  SampledState known;
  for (const ChosenValue& choice : *found) {
    MetChoice& met = known.choices.emplace_back();
    met.address = addresses_.address(choice.address);
    met.value = choice.value;
  }
  StateChoices choices(known);
  SampledState state;
  take(executor_.run(choices), state);
  if (!(state.log_density() > kImpossible)) return std::nullopt;
  return state;
}

/// What is drawn has the densities of the choices, so that the weights alone are left of the ratio.
double Rerun::restart(SampledState& proposed) {
  std::optional<Span> ruled_out;
  return draw(proposed, ruled_out) ? proposed.log_weight - state_->log_weight : kImpossible;
}

bool Rerun::draw(SampledState& state, std::optional<Span>& ruled_out) {
  positions_.clear();  // so that every choice is met for the first time
  Answers answers(*this);
  Execution& execution = executor_.run(answers);
  ruled_out = execution.rejection ? execution.rejection->whole : execution.weightless;
  fresh_values_.clear();
  take(execution, state);
  return state.log_density() > kImpossible;
}

void Rerun::take(Execution& execution, SampledState& state) {
  std::swap(state.choices, execution.choices);
  state.log_priors.clear();
  state.log_prior = 0;
  for (const MetChoice& choice : state.choices) {
    state.log_priors.push_back(choice.domain.log_density(choice.value));
    state.log_prior += state.log_priors.back();
  }
  state.log_weight = execution.log_weight - static_cast<double>(execution.cost);
  if (state.log_density() == HUGE_VAL) ++infinities_;
  if (execution.rejection || !std::isfinite(state.log_density())) state.log_weight = kImpossible;
  state.value = std::move(execution.value);
}

void Rerun::repeat(SampledState& repeated) {
  Answers answers(*this);
  take(executor_.run(answers), repeated);
}

void Rerun::stand_at(const SampledState& state) {
  state_ = &state;
  positions_.assign(addresses_.size(), kNowhere);
  for (std::uint32_t i = 0; i < state.choices.size(); ++i) positions_[state.choices[i].address.index] = i;
}

/// The logarithm of the density with which a step back would draw what this one forgets.
double Rerun::forgotten() const {
  double sum = 0;
  for (std::size_t i = 0; i < met_.size(); ++i)
    if (!met_[i]) sum += state_->log_priors[i];
  return sum;
}

/// The ways there and back differ in which choice is picked, one of n against one of n'; in which value it
/// gets; and in which values are drawn anew.
double Rerun::propose(std::size_t picked, const Proposal& proposal, SampledState& proposed) {
  if (!state_->choices[picked].domain.contains(proposal.value)) return kImpossible;
  Answers answers(*this);
  answers.change(static_cast<std::uint32_t>(picked), proposal.value);
  take(executor_.run(answers), proposed);
  fresh_values_.clear();
  if (!answers.possible() || !(proposed.log_density() > kImpossible)) return kImpossible;
  const auto count = static_cast<double>(state_->choices.size());
  const auto proposed_count = static_cast<double>(proposed.choices.size());
  return proposed.log_density() - state_->log_density() + proposal.log_ratio + forgotten() -
         answers.drawn_density() + std::log(count) - std::log(proposed_count);
}

}  // namespace solitaire
