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

bool OrderDifferences::visit_chain(std::uint32_t chain, const OrderChains& chains, Trail& trail) {
  if (!leave_taken(chain, chains, trail)) return false;
  if (chains[chain].is_decided()) {
    bool holds = true;
    for_each_taken(chain, chains[chain].reached,
                   [&](std::uint32_t other, std::uint32_t& entry, std::uint32_t step) {
                     if (entry != kFree || !holds) return;
                     entry = 1 + step;
                     holds = leave_taken(other, chains, trail);
                   });
    if (!holds) return false;
  }
  return std::ranges::all_of(guarded_of_.of(chain),
                             [&](std::uint32_t step) { return apply(step, chains, trail); });
}

/// Makes an int leave its lowest and its highest value, if another one took that.
bool OrderDifferences::leave_taken(std::uint32_t number, const OrderChains& chains, Trail& trail) const {
  const OrderChains::Chain& chain = chains[number];
  const std::uint32_t* const taken = taken_.data() + starts_[number];
  if (starts_[number] == starts_[number + 1]) return true;
  for (const std::uint32_t at : {chain.reached, chain.limit}) {
    if (taken[at] == kFree) continue;
    const Step& step = steps_[taken[at] - 1];
    const std::uint32_t position = step.a == number ? at : at - step.base + step.first;
    if (!apply(taken[at] - 1, position, chains, trail)) return false;
  }
  return true;
}

bool OrderDifferences::apply(std::uint32_t number, const OrderChains& chains, Trail& trail) const {
  const Step& step = steps_[number];
  const OrderChains::Chain &a = chains[step.a], &b = chains[step.b];
  if (a.is_decided()) {
    if (a.reached < step.first || a.reached >= step.first + step.count) return true;
    return apply(number, a.reached, chains, trail);
  }
  if (!b.is_decided() || b.reached < step.base || b.reached >= step.base + step.count) return true;
  return apply(number, b.reached - step.base + step.first, chains, trail);
}

bool OrderDifferences::apply(std::uint32_t step, std::uint32_t position, const OrderChains& chains,
                             Trail& trail) const {
  const Clause literals = clause(step, position, chains);
  int open = 0;
  for (const int literal : literals) {
    const int value = trail.value(literal);
    if (value > 0 || (value == 0 && open != 0)) return true;
    if (value == 0) open = literal;
  }
  if (open != 0) {
    trail.assign(open, {Reason::kDifference, static_cast<int>(step), static_cast<int>(position)});
    return true;
  }
  trail.break_clause({literals.begin(), literals.end()});
  return false;
}

}  // namespace solitaire
