#include "smt/cdcl/bounds/order_bounds.h"

namespace solitaire {

void OrderBounds::build(std::size_t variables) {
  chains_.build(variables);
  implications_.build(variables, chains_.size());
  differences_.build(variables, chains_);
  sums_.build(variables, chains_.size());
}

bool OrderBounds::visit(int assigned, Trail& trail) {
  // Most formulas have conditions of one kind only, and what is empty is not looked at.
  const auto follows = [&](std::uint32_t chain) {
    return (differences_.empty() || differences_.visit_chain(chain, chains_, trail)) &&
           (sums_.empty() || sums_.visit_chain(chain, chains_, trail));
  };
  for (const OrderChains::Place place : chains_.places(assigned)) {
    const OrderChains::Chain before = chains_[place.chain];
    if (!chains_.raise(place)) continue;
    if (!sums_.empty()) sums_.note(place.chain, before, chains_[place.chain]);
    if (!implications_.visit_raised(place.chain, chains_, trail) || !follows(place.chain)) return false;
  }
  for (const OrderChains::Place place : chains_.places(-assigned)) {
    const OrderChains::Chain before = chains_[place.chain];
    if (!chains_.lower(place)) continue;
    if (!sums_.empty()) sums_.note(place.chain, before, chains_[place.chain]);
    if (!implications_.visit_lowered(place.chain, chains_, trail) || !follows(place.chain)) return false;
  }
  return implications_.visit_guard(assigned, chains_, trail) &&
         (differences_.empty() || differences_.visit_guard(assigned, chains_, trail)) &&
         (sums_.empty() || sums_.visit_guard(assigned, chains_, trail));
}

void OrderBounds::undo_level() {
  while (chains_.changes() > levels_.back()) {
    const auto [chain, before] = chains_.undo_last();
    if (!differences_.empty()) differences_.undo(chain, before, chains_[chain]);
    if (!sums_.empty()) sums_.note(chain, before, chains_[chain]);
  }
  levels_.pop_back();
}

}  // namespace solitaire
