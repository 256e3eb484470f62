#include "smt/cdcl/nearby_search.h"

#include <algorithm>
#include <cstdlib>

namespace solitaire {
void NearbySearch::suggest(std::size_t variable, std::int64_t value) {
  if (suggestions_.size() <= variable) suggestions_.resize(variable + 1);
  suggestions_[variable] = value;
}

std::optional<std::int64_t> NearbySearch::suggestion(std::size_t variable) const {
  return variable < suggestions_.size() ? suggestions_[variable] : std::nullopt;
}

bool NearbySearch::find(std::span<const int> assumptions, const StopSignal& signal) {
  if (random_.below(100) < forgets_) queue_.clear();
  take_suggestions();
  return assume(assumptions) && search(signal);
}

void NearbySearch::undo_to(std::size_t decisions) {
  if (propagator_.decisions() <= decisions) return;
  for (const int literal : propagator_.trail(decisions + 1)) {
    want(std::abs(literal), literal > 0);
    queue_.open(std::abs(literal));
  }
  while (propagator_.decisions() > decisions) propagator_.undo();
}

void NearbySearch::end() {
  undo_to(0);
  if (propagator_.learned() > tuning::kMostLearned) propagator_.forget_half();
}

std::vector<int> NearbySearch::wanted() const {
  std::vector<int> literals;
  for (std::size_t choice = 0; choice < ordered_.size(); ++choice) {
    for (const int input : search_.inputs(choice)) literals.push_back(wanted(input));
  }
  return literals;
}

void NearbySearch::want(int variable, bool holds) {
  const auto at = static_cast<std::size_t>(variable);
  if (at >= wanted_.size()) wanted_.resize(2 * at + 1);
  wanted_[at] = holds ? 1 : 0;
}

void NearbySearch::take_suggestions() {
  numbers_.resize(choices_.size());
  for (std::size_t variable = 0; variable < numbers_.size(); ++variable) {
    const std::span<const Literal> inputs = choices_.inputs(variable);
    if (inputs.empty()) continue;
    if (!numbers_[variable]) add_choice(variable);
    const auto suggested = suggestion(variable);
    if (!suggested) continue;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (!is_constant(inputs[i])) want(cnf_.variable(inputs[i]), choices_.input_at(variable, i, *suggested));
    }
  }
}

void NearbySearch::add_choice(std::size_t variable) {
  numbers_[variable] = ordered_.size();
  ordered_.push_back(choices_.order(variable) != nullptr);
  search_.add(choices_.inputs(variable), cnf_);
  draw(ordered_.size() - 1);
}

bool NearbySearch::assume(std::span<const int> assumptions) {
  if (!propagator_.propagate()) return false;
  for (const int literal : assumptions) {
    propagator_.reserve(std::abs(literal));
    if (propagator_.value(literal) < 0) return false;
    if (!propagator_.is_open(literal)) continue;
    propagator_.decide(literal);
    if (!propagator_.propagate()) return false;
  }
  return true;
}

/// A search that succeeded may take more conflicts the next time, and one that failed fewer.
bool NearbySearch::search(const StopSignal& signal) {
  const std::size_t assumed = propagator_.decisions();
  const std::uint64_t most = most_conflicts();
  const std::uint64_t conflicts = conflicts_.value_or(most);
  const bool found = search_within(conflicts, assumed, signal);
  conflicts_ = std::clamp(found ? 2 * conflicts : conflicts / 4, tuning::kFewestConflicts, most);
  return found;
}

std::uint64_t NearbySearch::most_conflicts() const {
  return std::max(tuning::kMostConflicts, propagator_.spared_clauses() / tuning::kClausesPerConflict);
}

bool NearbySearch::search_within(std::uint64_t conflicts, std::size_t assumed, const StopSignal& signal) {
  for (std::uint64_t met = 0; met < conflicts;) {
    if (propagator_.propagate()) {
      const int literal = next_decision();
      if (literal == 0) return true;
      propagator_.decide(literal);
    } else {
      if (!learn(assumed) || (++met % tuning::kConflictsPerLookNearby == 0 && signal.stopped())) return false;
    }
  }
  return false;
}

/// Learns from the last conflict. Returns false if that follows from the assumptions alone.
bool NearbySearch::learn(std::size_t assumed) {
  if (propagator_.decisions() <= assumed) return false;
  analysis_.analyze(propagator_);
  queue_.move_to_front(analysis_.variables());
  undo_to(std::max(analysis_.decisions(), assumed));
  propagator_.learn(analysis_.clause());
  return true;
}

/// Returns the literal to decide next, or 0 if all choices are decided.
int NearbySearch::next_decision() {
  const int queued = queue_.first_open([this](int variable) { return propagator_.is_open(variable); });
  if (queued != 0) return wanted(queued);
  const auto choice = search_.next();
  if (!choice) return 0;
  if (!is_left(*choice)) draw(*choice);
  return decision(*choice);
}

/// Returns the input of a choice to decide, as it is wanted, which leaves the fewest others open. Of a choice
/// in order encoding it is one next to the wanted value.
int NearbySearch::decision(std::size_t choice) const {
  int decided = 0;
  for (const int input : search_.inputs(choice)) {
    if (propagator_.is_open(input) && (decided == 0 || wants(input))) decided = input;
  }
  return wanted(decided);
}

/// Returns true if the wanted value of a choice is still possible.
bool NearbySearch::is_left(std::size_t choice) const {
  return std::ranges::none_of(search_.inputs(choice),
                              [this](int input) { return propagator_.value(wanted(input)) < 0; });
}

/// Draws another value to want from those that are left.
void NearbySearch::draw(std::size_t choice) {
  const std::span<const int> inputs = search_.inputs(choice);
  const auto open = static_cast<std::size_t>(
      std::ranges::count_if(inputs, [this](int input) { return propagator_.is_open(input); }));
  std::uint64_t to_reach = ordered_[choice] ? random_.below(open + 1) : 0;
  for (const int input : inputs) {
    if (!propagator_.is_open(input)) {
      want(input, propagator_.value(input) > 0);
    } else if (ordered_[choice]) {
      want(input, to_reach > 0);
      to_reach -= to_reach > 0 ? 1 : 0;
    } else {
      want(input, random_.below(2) != 0);
    }
  }
}

}  // namespace solitaire
