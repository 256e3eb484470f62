#include "smt/cdcl/bounds/order_differences.h"

namespace solitaire {

void OrderDifferences::add(const OrderDifference& difference, OrderChains& chains) {
  steps_.push_back({difference.guard, chains.number(difference.a), chains.number(difference.b),
                    difference.first, difference.base, difference.count});
}

void OrderDifferences::build(std::size_t variables, const OrderChains& chains) {
  built_ = steps_.size();
  const auto by_chain = [&](bool is_guarded) {
    return GroupedTable<std::uint32_t>(chains.size(), [=, this](const auto& put) {
      for (std::uint32_t i = 0; i < built_; ++i) {
        if ((steps_[i].guard != 0) != is_guarded) continue;
        put(steps_[i].a, i);
        put(steps_[i].b, i);
      }
    });
  };
  always_ = by_chain(false);
  guarded_of_ = by_chain(true);
  guarded_ = {variables, [this](const auto& put) {
                for (std::uint32_t i = 0; i < built_; ++i) {
                  if (steps_[i].guard != 0) put(steps_[i].guard, i);
                }
              }};
  starts_.assign(chains.size() + 1, 0);
  for (std::uint32_t i = 0; i < chains.size(); ++i) {
    const std::size_t values = always_.of(i).empty() ? 0 : chains[i].literals.size() + 1;
    starts_[i + 1] = starts_[i] + static_cast<std::uint32_t>(values);
  }
  taken_.assign(starts_.back(), kFree);
}

void OrderDifferences::undo(std::uint32_t chain, const OrderChains::Chain& from,
                            const OrderChains::Chain& to) {
  if (!from.is_decided() || to.is_decided()) return;
  for_each_taken(chain, from.reached, [](std::uint32_t, std::uint32_t& entry, std::uint32_t step) {
    if (entry == 1 + step) entry = kFree;
  });
}

OrderDifferences::Clause OrderDifferences::clause(std::uint32_t number, std::uint32_t position,
                                                  const OrderChains& chains) const {
  const Step& step = steps_[number];
  Clause made;
  if (step.guard != 0) made.add(-step.guard);
  const auto add_other = [&](std::span<const int> chain, std::uint32_t at) {
    if (at > 0) made.add(-chain[at - 1]);
    if (at < chain.size()) made.add(chain[at]);
  };
  add_other(chains[step.a].literals, position);
  add_other(chains[step.b].literals, position - step.first + step.base);
  return made;
}

}  // namespace solitaire
