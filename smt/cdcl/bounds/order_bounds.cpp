#include "smt/cdcl/bounds/order_bounds.h"

namespace solitaire {

void OrderBounds::build(std::size_t variables) {
  chains_.build(variables);
  implications_.build(variables, chains_.size());
  differences_.build(variables, chains_);
  sums_.build(variables, chains_.size());
}

void OrderBounds::undo_to(std::size_t changes) {
  while (chains_.changes() > changes) {
    const auto [chain, before] = chains_.undo_last();
    if (!differences_.empty()) differences_.undo(chain, before, chains_[chain]);
    if (!sums_.empty()) sums_.note(chain, before, chains_[chain]);
  }
}

}  // namespace solitaire
