#include "smt/choice_search.h"

#include <algorithm>

namespace solitaire {

void ChoiceSearch::add(std::vector<int> inputs) {
  for (const int input : inputs) propagator_.reserve(input);
  choices_.push_back(std::move(inputs));
}

std::optional<std::size_t> ChoiceSearch::next(Order order) const {
  if (order == Order::kFirstFail) return first_fail();
  for (std::size_t i = 0; i < choices_.size(); ++i) {
    if (is_open(i)) return i;
  }
  return std::nullopt;
}

bool ChoiceSearch::is_open(std::size_t choice) const {
  return std::ranges::any_of(choices_[choice], [this](int input) { return propagator_.is_open(input); });
}

std::optional<std::size_t> ChoiceSearch::first_fail() const {
  std::ptrdiff_t fewest = PTRDIFF_MAX;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < choices_.size(); ++i) {
    const std::ptrdiff_t open = std::count_if(choices_[i].begin(), choices_[i].end(),
                                              [this](int input) { return propagator_.is_open(input); });
    if (open == 0 || open >= fewest) continue;
    fewest = open;
    best = i;
  }
  return best;
}

bool ChoiceSearch::turn_back(std::size_t kept) {
  if (propagator_.decisions() <= kept) return false;
  propagator_.assign(-propagator_.undo());
  return true;
}

}  // namespace solitaire
