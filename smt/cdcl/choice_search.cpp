#include "smt/cdcl/choice_search.h"

#include <cstdlib>

namespace solitaire {

void ChoiceSearch::add(std::span<const Literal> inputs, Cnf& cnf) {
  catch_up();  // before the choice's inputs are known, so that none of them is counted twice
  const auto choice = static_cast<std::uint32_t>(choices_.size());
  std::vector<int>& variables = choices_.emplace_back();
  for (const Literal input : inputs) {
    if (!is_constant(input)) variables.push_back(cnf.variable(input));
  }
  propagator_.reserve(cnf.variables());
  choice_of_.resize(propagator_.variables(), kNoChoice);
  open_.push_back(0);
  for (const int variable : variables) {
    choice_of_[static_cast<std::size_t>(variable)] = choice;
    if (propagator_.is_open(variable)) count(variable, 1);
  }
}

std::optional<std::size_t> ChoiceSearch::next() {
  catch_up();
  if (fewest_open_.least() == Tournament::kOut) return std::nullopt;
  return fewest_open_.first();
}

/// Counts what the propagator has taken back and assigned since the last call.
void ChoiceSearch::catch_up() {
  const std::size_t kept = propagator_.take_kept();
  for (std::size_t i = kept; i < counted_.size(); ++i) count(counted_[i], 1);
  counted_.resize(kept);
  for (const int literal : propagator_.trail().subspan(kept)) {
    counted_.push_back(std::abs(literal));
    count(counted_.back(), -1);
  }
  for (const std::uint32_t choice : changed_)
    fewest_open_.set(choice, open_[choice] == 0 ? Tournament::kOut : open_[choice]);
  changed_.clear();
}

void ChoiceSearch::count(int variable, int opened) {
  const auto at = static_cast<std::size_t>(variable);
  if (at >= choice_of_.size() || choice_of_[at] == kNoChoice) return;
  std::size_t& open = open_[choice_of_[at]];
  open = opened > 0 ? open + 1 : open - 1;
  changed_.push_back(choice_of_[at]);
}

bool ChoiceSearch::turn_back() {
  if (propagator_.decisions() == 0) return false;
  propagator_.assign(-propagator_.undo());
  return true;
}

}  // namespace solitaire
