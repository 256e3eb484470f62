#include "smt/cdcl/bounds/order_implications.h"

namespace solitaire {

void OrderImplications::add(const OrderImplication& order_implication, OrderChains& chains) {
  steps_.push_back({order_implication.guard, chains.number(order_implication.lower),
                    chains.number(order_implication.upper), order_implication.first, order_implication.base,
                    order_implication.count});
}

void OrderImplications::build(std::size_t variables, std::size_t chains) {
  built_ = steps_.size();
  const auto by_chain = [&](std::uint32_t Step::*chain) {
    return GroupedTable<std::uint32_t>(chains, [=, this](const auto& put) {
      for (std::uint32_t i = 0; i < built_; ++i) put(steps_[i].*chain, i);
    });
  };
  as_lower_ = by_chain(&Step::lower);
  as_upper_ = by_chain(&Step::upper);
  guarded_ = {variables, [this](const auto& put) {
                for (std::uint32_t i = 0; i < built_; ++i) put(steps_[i].guard, i);
              }};
}

/// Applies what follows from the lower int's bound: the upper int has at least some value or, if it cannot
bool OrderImplications::apply_reached(const Step& step, const OrderChains& chains, Trail& trail) {
  const OrderChains::Chain& lower = chains[step.lower];
  const int guard = trail.value(step.guard);
  if (lower.reached <= step.first || guard < 0) return true;
  const OrderChains::Chain& upper = chains[step.upper];
  const std::uint32_t at = step.base + std::min(lower.reached - 1 - step.first, step.count - 1);
  if (at < upper.limit && guard == 0) return true;
  return trail.apply(-step.guard, -lower.literals[lower.reached - 1],
                     upper.literals[std::min(at, upper.limit)]);
}

/// Applies what follows from the upper int's bound: the lower int has at most some value or, if it is beyond
bool OrderImplications::apply_limit(const Step& step, const OrderChains& chains, Trail& trail) {
  const OrderChains::Chain& upper = chains[step.upper];
  const int guard = trail.value(step.guard);
  if (upper.limit >= step.base + step.count || guard < 0) return true;
  const OrderChains::Chain& lower = chains[step.lower];
  const std::uint32_t at = step.first + (upper.limit > step.base ? upper.limit - step.base : 0);
  if (at >= lower.reached && guard == 0) return true;
  return trail.apply(-step.guard, -lower.literals[at < lower.reached ? lower.reached - 1 : at],
                     upper.literals[upper.limit]);
}

}  // namespace solitaire
