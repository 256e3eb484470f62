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

}  // namespace solitaire
