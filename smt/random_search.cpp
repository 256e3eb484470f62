#include "smt/random_search.h"

#include <algorithm>
#include <cstdlib>

namespace solitaire {

void RandomSearch::suggest(std::size_t variable, std::int64_t value) {
  if (suggestions_.size() <= variable) suggestions_.resize(variable + 1);
  suggestions_[variable] = value;
}

std::optional<std::int64_t> RandomSearch::suggestion(std::size_t variable) const {
  return variable < suggestions_.size() ? suggestions_[variable] : std::nullopt;
}

bool RandomSearch::find(std::span<const int> assumptions) {
  take_suggestions();
  if (assume(assumptions)) {
    const std::size_t assumed = propagator_.decisions();
    std::ranges::stable_sort(manners_, {}, &Manner::cost);
    for (Manner& manner : manners_) {
      if (search(manner, assumed)) return true;
    }
    want_together(assumed);
  }
  return false;
}

/// Wants what a single descent from the suggestions comes to.
void RandomSearch::want_together(std::size_t assumed) {
  undo_to(assumed);
  take_suggestions();
  std::uint64_t none = 0;
  descend({ChoiceSearch::Order::kFirstFail, 0, 1}, assumed, none);
  for (std::size_t choice = 0; choice < choices_.size(); ++choice) want_what_is_left(choice);
}

void RandomSearch::undo_to(std::size_t decisions) {
  while (propagator_.decisions() > decisions) propagator_.undo();
}

void RandomSearch::end() { undo_to(0); }

std::vector<int> RandomSearch::wanted() const {
  std::vector<int> literals;
  for (std::size_t choice = 0; choice < choices_.size(); ++choice) {
    for (std::size_t input = 0; input < choices_[choice].wanted.size(); ++input)
      literals.push_back(literal(choice, input));
  }
  return literals;
}

void RandomSearch::take_suggestions() {
  numbers_.resize(blaster_.choices());
  for (std::size_t variable = 0; variable < numbers_.size(); ++variable) {
    const std::span<const Literal> inputs = blaster_.choice_inputs(variable);
    if (inputs.empty()) continue;
    if (!numbers_[variable]) add_choice(variable);
    const auto suggested = suggestion(variable);
    if (!suggested) continue;
    std::vector<char>& wanted = choices_[*numbers_[variable]].wanted;
    wanted.clear();
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      if (is_constant(inputs[i])) continue;
      wanted.push_back(blaster_.input_at(variable, i, *suggested) ? 1 : 0);
    }
  }
}

void RandomSearch::add_choice(std::size_t variable) {
  std::vector<int> inputs;
  for (const Literal input : blaster_.choice_inputs(variable)) {
    if (!is_constant(input)) inputs.push_back(cnf_.variable(input));
  }
  numbers_[variable] = choices_.size();
  choices_.push_back({blaster_.is_ordered(variable), std::vector<char>(inputs.size())});
  search_.add(std::move(inputs));
  draw(choices_.size() - 1);
}

bool RandomSearch::assume(std::span<const int> assumptions) {
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

/// What succeeds is worth more effort the next time, what does not is worth less.
bool RandomSearch::search(Manner& manner, std::size_t assumed) {
  undo_to(assumed);
  std::uint64_t left = manner.dead_ends;
  const bool found = descend(manner, assumed, left);
  const auto met = static_cast<double>(found ? manner.dead_ends - left : manner.most_dead_ends);
  manner.cost = (manner.cost + met) / 2;
  manner.dead_ends = found ? manner.most_dead_ends : manner.dead_ends / 4;
  return found;
}

/// Until there is no dead end left to be met.
bool RandomSearch::descend(const Manner& manner, std::size_t assumed, std::uint64_t& left) {
  while (true) {
    if (propagator_.propagate()) {
      const auto choice = search_.next(manner.order);
      if (!choice) return true;
      want_what_is_left(*choice);
      propagator_.decide(decision(*choice));
    } else {
      if (left == 0 || !search_.turn_back(assumed)) return false;
      if (--left % manner.run != 0) continue;
      undo_to(assumed);
      for (std::size_t choice = 0; choice < choices_.size(); ++choice) draw(choice);
    }
  }
}

/// The input that leaves the fewest others open, as it is wanted: of an ordered choice one next to the value
/// that is wanted.
int RandomSearch::decision(std::size_t choice) const {
  const std::span<const int> inputs = search_.inputs(choice);
  std::size_t decided = inputs.size();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!propagator_.is_open(inputs[i])) continue;
    if (decided == inputs.size() || choices_[choice].wanted[i] != 0) decided = i;
  }
  return literal(choice, decided);
}

int RandomSearch::literal(std::size_t choice, std::size_t input) const {
  const int variable = search_.inputs(choice)[input];
  return choices_[choice].wanted[input] != 0 ? variable : -variable;
}

void RandomSearch::want_what_is_left(std::size_t choice) {
  if (!is_left(choice)) draw(choice);
}

/// Whether nothing is decided against the value that is wanted.
bool RandomSearch::is_left(std::size_t choice) const {
  for (std::size_t i = 0; i < choices_[choice].wanted.size(); ++i) {
    if (propagator_.value(literal(choice, i)) < 0) return false;
  }
  return true;
}

/// Another value to want, of those that are left.
void RandomSearch::draw(std::size_t choice) {
  const std::span<const int> inputs = search_.inputs(choice);
  const auto open = static_cast<std::size_t>(
      std::ranges::count_if(inputs, [this](int input) { return propagator_.is_open(input); }));
  auto& [ordered, wanted] = choices_[choice];
  std::size_t to_reach = ordered ? below(open + 1) : 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!propagator_.is_open(inputs[i])) {
      wanted[i] = propagator_.value(inputs[i]) > 0 ? 1 : 0;
    } else if (ordered) {
      wanted[i] = to_reach > 0 ? 1 : 0;
      to_reach -= wanted[i] != 0 ? 1 : 0;
    } else {
      wanted[i] = static_cast<char>(below(2));
    }
  }
}

/// From 0 to one less than the bound, which is so small that the modulus favours nothing visibly.
std::size_t RandomSearch::below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

}  // namespace solitaire
