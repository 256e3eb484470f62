#include "engines/sample/shred.h"

#include <algorithm>
#include <fmt/format.h>

#include "engines/errors.h"
#include "engines/sample/conditional.h"
#include "engines/tuning.h"
#include "solitaire/value/plain_copy.h"

namespace solitaire {

ShredChain::ShredChain(const Program& program, const ParamValues& params, const Limits& limits,
                       std::uint64_t seed, std::uint64_t number, Restarts restarts)
    : program_(program),
      params_(params),
      limits_(limits),
      returned_(program),
      stream_(seed, Purpose::kChain, number),
      rerun_(program, params, limits, stream_),
      proposer_(stream_),
      slice_sampler_(stream_),
      state_(rerun_.start()),
      restarts_(restarts) {
  enter();
}

// ---- steps

void ShredChain::sweep() {
  if (warming_up_) steps_in_sweep_ = std::max(steps_in_sweep_, choices());
  scan();
  for (std::size_t i = 0; i < steps_in_sweep_; ++i) step();
  if (structure_ != nullptr) move_jointly();
  if (restarts_.wanted()) restart();
}

/// Choices that no branch depends on have their turns one after the other, which is worth about twice as much
/// as if they were picked (Roberts and Sahu 1997). The order may not depend on the state: these choices are
/// the same in all states that they lead to.
void ShredChain::scan() {
  for (ChoiceNumber i = 0; structure_ != nullptr && i < choices(); ++i)
    if (keeps_path(i) && !step_by_form(i)) step_by_proposal(i);
}

bool ShredChain::keeps_path(ChoiceNumber choice) const {
  return structure_->kernel.slice(choice).assumed.empty();
}

/// A step that would leave the path is refused, as the one back would be.
void ShredChain::move_jointly() {
  if (joint_move_ == nullptr) return;
  if (joint_move_->ready()) {
    const bool moved = joint_move_->move(structure_->kernel, stream_, warming_up_);
    moves_.add(Move::kJoint, moved);
  }
  if (warming_up_) joint_move_->watch(structure_->kernel);
}

/// The joint move of the present structure. Those with the same floats share one.
JointMove* ShredChain::find_joint_move() {
  const std::vector<ChoiceNumber>& floats = structure_->kernel.floats();
  if (floats.size() < 2) return nullptr;
  std::vector<std::uint32_t> addresses;
  bool has_unknown = false;
  for (const ChoiceNumber each : floats) {
    addresses.push_back(structure_->kernel.program().choices[each].address.index);
    has_unknown = has_unknown || structure_->forms[each] == Form::kUnknown;
  }
  const auto found = joint_moves_.find(addresses);
  if (found != joint_moves_.end()) return &found->second;
  if (!warming_up_) return nullptr;
  return &joint_moves_.try_emplace(std::move(addresses), floats.size(), has_unknown).first->second;
}

void ShredChain::restart() {
  if (structure_ != nullptr) fetch_state();
  rerun_.stand_at(state_);
  const bool accepted = accepts(rerun_.restart(proposed_));
  moves_.add(Move::kRestart, accepted);
  restarts_.told(accepted);
  if (!accepted) return;
  std::swap(state_, proposed_);
  enter();
}

/// Picks one of all choices, and changes it unless it has had its turn.
void ShredChain::step() {
  if (choices() == 0) return;
  const ChoiceNumber choice = stream_.below(choices());
  if (structure_ == nullptr || !keeps_path(choice)) step_by_proposal(choice);
}

std::size_t ShredChain::choices() const {
  return structure_ != nullptr ? structure_->kernel.program().choices.size() : state_.choices.size();
}

/// Draws the choice, on which no branch depends, from its distribution given all others, if that is known.
bool ShredChain::step_by_form(ChoiceNumber choice) {
  Kernel& kernel = structure_->kernel;
  const ScoreProgram::Choice& at = kernel.program().choices[choice];
  if (at.cell == kNoCell) return true;  // has one value alone
  if (at.distribution.is_finite()) {
    const Distribution distribution = kernel.domain(choice);
    if (distribution.size() > tuning::kMostValuesCompared) return false;
    change(choice, draw_of_few(kernel, choice, distribution, stream_), Move::kGibbs);
    return true;
  }
  const Form form = structure_->forms[choice];
  if (form == Form::kUnknown) return false;
  const std::optional<Scalar> value = draw_of_form(kernel, choice, form, stream_);
  if (value) change(choice, *value, Move::kGibbs);
  return value.has_value();
}

/// A value that other conditions rule out is refused, which is a step of Metropolis's.
void ShredChain::change(ChoiceNumber choice, Scalar value, Move move) {
  if (bits_of(value) == bits_of(structure_->kernel.value(choice))) return moves_.add(move, true);
  const bool possible = structure_->kernel.propose(choice, value) == Kernel::Outcome::kScored;
  moves_.add(move, possible);
  if (possible) structure_->kernel.accept();
}

/// Half of the steps go anywhere, and half close by: by slice sampling, unless a branch depends on the
/// choice.
void ShredChain::step_by_proposal(ChoiceNumber choice) {
  if (structure_ == nullptr) {
    const MetChoice& at = state_.choices[choice];
    return step_by_rerun(choice, proposer_.propose(at.address, at.domain, at.value));
  }
  Kernel& kernel = structure_->kernel;
  const bool has_branch = !keeps_path(choice);
  if (!has_branch && stream_.below(2) == 0) {
    if (!moves_with_others(choice))
      change(choice, slice_sampler_.draw(kernel, choice, warming_up_), Move::kSlice);
    return;
  }
  const Distribution distribution = kernel.distribution(choice);
  const AddressId address = kernel.program().choices[choice].address;
  const TypedScalar present(distribution.type(), kernel.value(choice));
  const Proposal proposal = has_branch ? proposer_.propose(address, distribution, present)
                                       : proposer_.anywhere(distribution, present);
  double log_ratio = -HUGE_VAL;
  if (distribution.contains(proposal.value)) {
    const Kernel::Outcome outcome = kernel.propose(choice, proposal.value.scalar());
    if (outcome == Kernel::Outcome::kLeavesTrace) {
      fetch_state();
      return step_by_rerun(choice, proposal);
    }
    if (outcome == Kernel::Outcome::kScored) log_ratio = kernel.difference() + proposal.log_ratio;
  }
  learn(address, proposal, log_ratio);
  const bool accepted = accepts(log_ratio);
  moves_.add(proposal.move, accepted);
  if (accepted) kernel.accept();
}

bool ShredChain::moves_with_others(ChoiceNumber choice) const {
  const ScoreProgram& program = structure_->kernel.program();
  return program.types[program.choices[choice].cell] == Type::kFloat && joint_move_ != nullptr &&
         joint_move_->ready();
}

void ShredChain::step_by_rerun(ChoiceNumber choice, const Proposal& proposal) {
  const AddressId address = state_.choices[choice].address;
  rerun_.stand_at(state_);
  const double log_ratio = rerun_.propose(choice, proposal, proposed_);
  learn(address, proposal, log_ratio);
  const bool accepted = accepts(log_ratio);
  moves_.add(proposal.move, accepted);
  if (!accepted) return;
  std::swap(state_, proposed_);
  enter();
}

void ShredChain::learn(AddressId address, const Proposal& proposal, double log_ratio) {
  if (warming_up_ && proposal.move == Move::kWalk)
    proposer_.learn(address, std::exp(std::min(log_ratio, 0.0)));
}

void ShredChain::end_warmup() {
  warming_up_ = false;
  restarts_.end_warmup();
  for (auto& [addresses, move] : joint_moves_) move.end_warmup();
  moves_.clear();
}

// ---- paths

/// Takes over the kernel's values.
void ShredChain::fetch_state() {
  const Kernel& kernel = structure_->kernel;
  const double log_density = kernel.log_score();
  state_.log_prior = 0;
  for (ChoiceNumber i = 0; i < state_.choices.size(); ++i) {
    MetChoice& choice = state_.choices[i];
    choice.domain = kernel.distribution(i);
    choice.value = TypedScalar(choice.domain.type(), kernel.value(i));
    state_.log_priors[i] = choice.domain.log_density(choice.value);
    state_.log_prior += state_.log_priors[i];
  }
  state_.log_weight = log_density - state_.log_prior;
}

/// Finds or makes the kernel of the path that the state takes.
void ShredChain::enter() {
  structure_ = find();
  if (structure_ == nullptr && !slowed_by_) {
    try {
      TracedStructure made =
          trace_structure(program_, params_, state_, rerun_.addresses(), limits_, returned_);
      if (structures_.size() == tuning::kMostTraces) structures_.erase(structures_.begin());
      structures_.push_back(std::make_unique<TracedStructure>(std::move(made)));
    } catch (const ProgramError& error) {
      slowed_by_ = error.diagnostics().front();
      joint_move_ = nullptr;
      return;
    }
    structure_ = structures_.back().get();
    if (!structure_->load(state_)) throw InternalError("a trace does not take the path of its own execution");
  }
  joint_move_ = structure_ != nullptr ? find_joint_move() : nullptr;
  if (structure_ != nullptr) check_density();
}

TracedStructure* ShredChain::find() {
  for (const auto& structure : structures_)
    if (structure->load(state_)) return structure.get();
  return nullptr;
}

void ShredChain::check_density() const {
  const double traced = structure_->kernel.log_score();
  const double run = state_.log_density();
  const double size = 1 + std::abs(state_.log_prior) + std::abs(state_.log_weight);
  if (std::abs(traced - run) <= tuning::kDensityTolerance * size) return;
  throw InternalError(
      fmt::format("the trace of an execution has the log density {}, and the execution has {}", traced, run));
}

void ShredChain::read(const ReturnedNumbers& returned, std::vector<std::string>& names,
                      std::vector<double>& numbers) {
  if (structure_ == nullptr) return returned.read(plain(state_.value), names, numbers);
  names = structure_->names;
  numbers = structure_->kernel.outputs();
}

}  // namespace solitaire
