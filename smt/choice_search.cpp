#include "smt/choice_search.h"

#include <algorithm>

namespace solitaire {

void ChoiceSearch::add(std::vector<int> inputs) {
  for (const int input : inputs) propagator_.reserve(input);
  choices_.push_back(std::move(inputs));
}

std::optional<std::size_t> ChoiceSearch::next() const {
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

bool ChoiceSearch::turn_back() {
  if (propagator_.decisions() == 0) return false;
  propagator_.assign(-propagator_.undo());
  return true;
}

}  // namespace solitaire
