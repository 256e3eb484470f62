#include "smt/cdcl/choice_search.h"

#include <cstdint>

namespace solitaire {

void ChoiceSearch::add(std::span<const Literal> inputs, Cnf& cnf) {
  std::vector<int>& variables = choices_.emplace_back();
  for (const Literal input : inputs) {
    if (!is_constant(input)) variables.push_back(cnf.variable(input));
  }
  propagator_.reserve(cnf.variables());
}

std::optional<std::size_t> ChoiceSearch::next() const {
  std::size_t fewest = SIZE_MAX;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < choices_.size() && fewest > 1; ++i) {
    const std::size_t open = count_open(i, fewest);
    if (open == 0 || open >= fewest) continue;
    fewest = open;
    best = i;
  }
  return best;
}

/// How many inputs of a choice are open, if there are fewer than that.
std::size_t ChoiceSearch::count_open(std::size_t choice, std::size_t bound) const {
  std::size_t open = 0;
  for (const int input : choices_[choice]) {
    if (propagator_.is_open(input) && ++open >= bound) break;
  }
  return open;
}

bool ChoiceSearch::turn_back() {
  if (propagator_.decisions() == 0) return false;
  propagator_.assign(-propagator_.undo());
  return true;
}

}  // namespace solitaire
