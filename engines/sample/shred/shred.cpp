#include "engines/sample/shred/shred.h"

#include <algorithm>

#include "engines/sample/acceptance.h"
#include "engines/tuning.h"
#include "solitaire/value/plain_copy.h"

namespace solitaire {

ShredChain::ShredChain(const Program& program, const ParamValues& params, const Limits& limits,
                       std::uint64_t seed, std::uint64_t number, Restarts restarts)
    : stream_(seed, Purpose::kChain, number),
      rerun_(program, params, limits, stream_),
      proposer_(stream_),
      path_moves_(stream_, proposer_, moves_),
      joint_moves_(stream_, moves_),
      known_paths_(program, params, limits),
      path_run_(stream_, rerun_.fresh_values()),
      proposed_(rerun_.start()),
      restarts_(restarts) {
  enter_proposed();
}

void ShredChain::sweep() {
  if (warming_up_) steps_in_sweep_ = std::max(steps_in_sweep_, choices());
  if (structure_ != nullptr) path_moves_.scan(*structure_, joint_moves_.ready(), warming_up_);
  for (std::size_t i = 0; i < steps_in_sweep_; ++i) step();
  if (structure_ != nullptr) {
    joint_moves_.move(structure_->kernel);
    look_at_infinity();
  }
  if (restarts_.wanted()) restart();
  if (++sweeps_ % tuning::kSweepsBetweenChecks == 0) compare_with_run();
}

std::size_t ShredChain::choices() const {
  return structure_ != nullptr ? structure_->kernel.program().choices.size() : state_.choices.size();
}

/// Picks one of all choices, and changes it unless it has had its turn.
void ShredChain::step() {
  if (choices() == 0 || (structure_ != nullptr && !structure_->branches)) return;
  const ChoiceNumber choice = stream_.pick(static_cast<std::uint32_t>(choices()));
  if (structure_ == nullptr) {
    const MetChoice& at = state_.choices[choice];
    step_by_rerun(choice, proposer_.propose(at.address, at.domain, at.value));
  } else if (!structure_->keeps_path(choice)) {
    step_on_trace(choice);
  }
}

void ShredChain::step_on_trace(ChoiceNumber choice) {
  Kernel& kernel = structure_->kernel;
  const Distribution& distribution = kernel.domain(choice);
  const AddressId address = kernel.program().choices[choice].address;
  const Proposal proposal =
      proposer_.propose(address, distribution, TypedScalar(distribution.type(), kernel.value(choice)));
  double log_ratio = -HUGE_VAL;
  if (distribution.contains(proposal.value)) {
    const Kernel::Outcome outcome = kernel.propose(choice, proposal.value.scalar());
    if (outcome == Kernel::Outcome::kLeavesTrace) return leave_path(choice, proposal);
    if (outcome == Kernel::Outcome::kScored) log_ratio = kernel.difference() + proposal.log_ratio;
  }
  if (accepts(proposal, log_ratio, address)) kernel.accept();
}

bool ShredChain::accepts(const Proposal& proposal, double log_ratio, AddressId address) {
  if (warming_up_ && proposal.move == Move::kWalk)
    proposer_.learn(address, std::exp(std::min(log_ratio, 0.0)));
  const bool accepted = solitaire::accepts(log_ratio, stream_.uniform());
  moves_.add(proposal.move, accepted);
  return accepted;
}

// ---- other paths

void ShredChain::leave_path(ChoiceNumber choice, const Proposal& proposal) {
  Kernel& kernel = structure_->kernel;
  kernel.refresh();
  Passages& passages = structure_->passages;
  for (const Passage* passage : passages.drawing())
    if (step_through(*passage, choice, proposal)) return;
  for (const Passage* passage : passages.of(choice)) {
    if (passage->draws_block || !step_through(*passage, choice, proposal)) continue;
    return passages.repeat(choice, passage);
  }
  fetch_state();
  step_by_rerun(choice, proposal);
}

/// Returns false if the passage does not lead to where the proposal does.
bool ShredChain::step_through(const Passage& passage, ChoiceNumber choice, const Proposal& proposal) {
  const std::optional<double> log_ratio = path_run_.propose(*structure_, choice, proposal, passage);
  if (!log_ratio) return false;
  rerun_.fresh_values().clear();
  if (accepts(proposal, *log_ratio, structure_->kernel.program().choices[choice].address)) enter(passage.to);
  return true;
}

void ShredChain::step_by_rerun(ChoiceNumber choice, const Proposal& proposal) {
  rerun_.stand_at(state_);
  const double log_ratio = rerun_.propose(choice, proposal, proposed_);
  const bool accepted = accepts(proposal, log_ratio, state_.choices[choice].address);
  TracedStructure* const before = structure_;
  if (accepted) {
    enter_proposed();
    note_passage(before, choice, structure_);
  } else if (before != nullptr && log_ratio > -HUGE_VAL) {
    foresee(choice);
  }
}

/// A path that is hardly ever taken, and yet proposed again and again, is worth being traced, too.
void ShredChain::foresee(ChoiceNumber choice) {
  if (known_paths_.full() || ++foreseeable_ % tuning::kStepsToTrace != 0) return;
  note_passage(structure_, choice, known_paths_.structure_of(proposed_, rerun_.addresses(), structure_));
}

void ShredChain::note_passage(TracedStructure* from, ChoiceNumber choice, TracedStructure* to) {
  if (from != nullptr && to != nullptr && from != to)
    from->passages.add(from->kernel, choice, to, to->kernel);
}

// ---- executions that are drawn anew

void ShredChain::restart() {
  const double log_least = std::log(stream_.uniform());
  std::optional<bool> taken;
  if (structure_ != nullptr) taken = restart_on_trace(log_least);
  if (!taken) taken = restart_by_rerun(log_least);
  moves_.add(Move::kRestart, *taken);
  restarts_.told(*taken);
}

/// Returns nothing where the execution takes none of the paths that were taken last.
std::optional<bool> ShredChain::restart_on_trace(double log_least) {
  Kernel& present = structure_->kernel;
  present.refresh();
  double log_weight = present.log_score();
  for (ChoiceNumber i = 0; i < choices(); ++i) log_weight -= log_prior(present, i);
  present.keep(kept_);
  for (const auto& each : known_paths_.latest(tuning::kMostPassages)) {
    const std::optional<double> proposed = path_run_.restart(each->kernel);
    if (!proposed) continue;
    rerun_.fresh_values().clear();
    const bool taken = *proposed - log_weight > log_least;
    if (!taken || each.get() != structure_) present.come_back(kept_);
    if (taken) enter(each.get());
    return taken;
  }
  present.come_back(kept_);
  return std::nullopt;
}

bool ShredChain::restart_by_rerun(double log_least) {
  fetch_state();
  rerun_.stand_at(state_);
  const bool taken = rerun_.restart(proposed_) > log_least;
  if (taken) enter_proposed();
  return taken;
}

// ---- the present state

void ShredChain::fetch_state() {
  if (structure_ == nullptr) return;
  structure_->kernel.refresh();
  state_ = state_of(structure_->kernel);
}

void ShredChain::enter(TracedStructure* structure) {
  structure_ = structure;
  if (structure != nullptr) known_paths_.use(structure);
  joint_moves_.enter(structure);
}

void ShredChain::enter_proposed() {
  std::swap(state_, proposed_);
  enter(known_paths_.structure_of(state_, rerun_.addresses()));
}

/// Executions that only traces have computed have to be what the program makes of their choices.
void ShredChain::compare_with_run() {
  if (structure_ == nullptr) return;
  fetch_state();
  rerun_.stand_at(state_);
  rerun_.repeat(proposed_);
  check_density(structure_->kernel, proposed_);
}

/// Where a density is infinite the program makes a mistake, as a run says with its place. What is infinite
/// all the same is refused.
void ShredChain::look_at_infinity() {
  const std::optional<std::vector<Scalar>> values = structure_->kernel.take_infinite();
  if (!values) return;
  fetch_state();
  SampledState infinite = state_;
  for (ChoiceNumber i = 0; i < values->size(); ++i) {
    TypedScalar& value = infinite.choices[i].value;
    value = TypedScalar(value.type(), (*values)[i]);
  }
  rerun_.stand_at(infinite);
  rerun_.repeat(proposed_);
  rerun_.stand_at(state_);
}

void ShredChain::end_warmup() {
  warming_up_ = false;
  restarts_.end_warmup();
  joint_moves_.end_warmup();
  known_paths_.end_warmup();
  moves_.clear();
}

Troubles ShredChain::troubles() const {
  Troubles troubles = moves_.troubles();
  troubles.infinities = rerun_.infinities() + known_paths_.infinities();
  return troubles;
}

void ShredChain::read(const ReturnedNumbers& returned, std::vector<std::string>& names,
                      std::vector<double>& numbers) {
  if (structure_ == nullptr) return returned.read(plain(state_.value), names, numbers);
  names = structure_->names;
  numbers = structure_->kernel.outputs();
}

}  // namespace solitaire
