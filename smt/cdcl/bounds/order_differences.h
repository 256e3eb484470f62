#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "smt/cdcl/bounds/order_chains.h"
#include "smt/sat/cnf.h"
#include "smt/sat/grouped_table.h"
#include "smt/sat/literal_table.h"

namespace solitaire {

/// Finds what follows from order differences by looking at bounds. Of the clauses that an order difference
/// stands for, only one says anything: that of the value at which one of the two ints is decided. It makes
/// the other one leave that value, once this is its lowest or its highest one.
///
/// Where differences always hold, each int has a table of the values that others took from it. So what an int
/// that is decided costs is one entry for each other int, and what a bound that moves costs is a look at its
/// value. Differences under guards are gone through with each change.
class OrderDifferences {
 public:
  void add(const OrderDifference& difference, OrderChains& chains);
  void build(std::size_t variables, const OrderChains& chains);
  bool has_new() const { return built_ < steps_.size(); }
  bool empty() const { return steps_.empty(); }
  template <class Visit>
  void for_each_guard(Visit visit) const {
    for (const Step& step : steps_) visit(step.guard);
  }

  /// Each of these looks at what follows since a bound of a chain has changed, or since a guard holds.
  /// host.assign_by_difference(literal, step, position) assigns what follows from a clause. Returns false if
  /// a clause is broken, after host.break_clause(its literals).
  template <class Host>
  bool visit_chain(std::uint32_t chain, const OrderChains& chains, Host& host);
  template <class Host>
  bool visit_guard(int guard, const OrderChains& chains, Host& host) const {
    return std::ranges::all_of(guarded_.of(guard),
                               [&](std::uint32_t step) { return apply(step, chains, host); });
  }
  /// Takes note that a chain was taken back from a state.
  void undo(std::uint32_t chain, const OrderChains::Chain& from, const OrderChains::Chain& to);

  /// The clause of a step that the two ints are not both at a value, given by its position in the first one.
  class Clause {
   public:
    void add(int literal) { literals_[size_++] = literal; }
    const int* begin() const { return literals_.data(); }
    const int* end() const { return literals_.data() + size_; }

   private:
    std::array<int, 5> literals_;
    std::uint32_t size_ = 0;
  };
  Clause clause(std::uint32_t step, std::uint32_t position, const OrderChains& chains) const;

 private:
  /// An order difference, whose chains are given by their numbers.
  struct Step {
    int guard;
    std::uint32_t a, b;
    std::uint32_t first, base, count;
  };
  static constexpr std::uint32_t kFree = 0;

  /// Calls visit(chain, entry, step) with the entry of each value that a decided chain takes from another.
  template <class Visit>
  void for_each_taken(std::uint32_t chain, std::uint32_t position, Visit visit);
  template <class Host>
  bool leave_taken(std::uint32_t chain, const OrderChains& chains, Host& host) const;
  template <class Host>
  bool apply(std::uint32_t step, const OrderChains& chains, Host& host) const;
  template <class Host>
  bool apply(std::uint32_t step, std::uint32_t position, const OrderChains& chains, Host& host) const;

  std::vector<Step> steps_;
  std::size_t built_ = 0;                            // so many of the steps are in the tables
  GroupedTable<std::uint32_t> always_, guarded_of_;  // the steps of each chain, without a guard and with one
  LiteralTable<std::uint32_t> guarded_;              // the steps of each guard
  std::vector<std::uint32_t> starts_;                // by chain: where its values stand in taken_
  std::vector<std::uint32_t> taken_;                 // by value: 1 + the step that took it first, or kFree
};

template <class Host>
bool OrderDifferences::visit_chain(std::uint32_t chain, const OrderChains& chains, Host& host) {
  if (!leave_taken(chain, chains, host)) return false;
  if (chains[chain].is_decided()) {
    bool holds = true;
    for_each_taken(chain, chains[chain].reached,
                   [&](std::uint32_t other, std::uint32_t& entry, std::uint32_t step) {
                     if (entry != kFree || !holds) return;
                     entry = 1 + step;
                     holds = leave_taken(other, chains, host);
                   });
    if (!holds) return false;
  }
  return std::ranges::all_of(guarded_of_.of(chain),
                             [&](std::uint32_t step) { return apply(step, chains, host); });
}

template <class Visit>
void OrderDifferences::for_each_taken(std::uint32_t chain, std::uint32_t position, Visit visit) {
  for (const std::uint32_t number : always_.of(chain)) {
    const Step& step = steps_[number];
    const bool is_first = step.a == chain;
    const std::uint32_t at = position - (is_first ? step.first : step.base);
    if (at >= step.count) continue;
    const std::uint32_t other = is_first ? step.b : step.a;
    visit(other, taken_[starts_[other] + at + (is_first ? step.base : step.first)], number);
  }
}

/// Makes an int leave its lowest and its highest value, if another one took that.
template <class Host>
bool OrderDifferences::leave_taken(std::uint32_t number, const OrderChains& chains, Host& host) const {
  const OrderChains::Chain& chain = chains[number];
  const std::uint32_t* const taken = taken_.data() + starts_[number];
  if (starts_[number] == starts_[number + 1]) return true;
  for (const std::uint32_t at : {chain.reached, chain.limit}) {
    if (taken[at] == kFree) continue;
    const Step& step = steps_[taken[at] - 1];
    const std::uint32_t position = step.a == number ? at : at - step.base + step.first;
    if (!apply(taken[at] - 1, position, chains, host)) return false;
  }
  return true;
}

template <class Host>
bool OrderDifferences::apply(std::uint32_t number, const OrderChains& chains, Host& host) const {
  const Step& step = steps_[number];
  const OrderChains::Chain &a = chains[step.a], &b = chains[step.b];
  if (a.is_decided()) {
    if (a.reached < step.first || a.reached >= step.first + step.count) return true;
    return apply(number, a.reached, chains, host);
  }
  if (!b.is_decided() || b.reached < step.base || b.reached >= step.base + step.count) return true;
  return apply(number, b.reached - step.base + step.first, chains, host);
}

/// Assigns the only literal of a clause that is not false, if there is only one.
template <class Host>
bool OrderDifferences::apply(std::uint32_t step, std::uint32_t position, const OrderChains& chains,
                             Host& host) const {
  const Clause literals = clause(step, position, chains);
  int open = 0;
  for (const int literal : literals) {
    const int value = host.value(literal);
    if (value > 0 || (value == 0 && open != 0)) return true;
    if (value == 0) open = literal;
  }
  if (open != 0) {
    host.assign_by_difference(open, step, position);
    return true;
  }
  host.break_clause({literals.begin(), literals.end()});
  return false;
}

}  // namespace solitaire
