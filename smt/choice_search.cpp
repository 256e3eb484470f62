#include "smt/choice_search.h"

#include <algorithm>

namespace solitaire {

void ChoiceSearch::add(std::span<const Literal> inputs, Cnf& cnf) {
  std::vector<int>& variables = choices_.emplace_back();
  for (const Literal input : inputs) {
    if (!is_constant(input)) variables.push_back(cnf.variable(input));
  }
  propagator_.reserve(cnf.variables());
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
