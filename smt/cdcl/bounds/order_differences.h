#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grouped_table.h"
#include "smt/cdcl/bounds/order_chains.h"
#include "smt/cdcl/trail.h"
#include "smt/sat/cnf.h"
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

  /// Each of these assigns what follows since a bound of a chain has changed, or since a guard holds. Returns
  /// false if a clause is broken.
  bool visit_chain(std::uint32_t chain, const OrderChains& chains, Trail& trail);
  bool visit_guard(int guard, const OrderChains& chains, Trail& trail) const {
    return std::ranges::all_of(guarded_.of(guard),
                               [&](std::uint32_t step) { return apply(step, chains, trail); });
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
  bool leave_taken(std::uint32_t chain, const OrderChains& chains, Trail& trail) const;
  bool apply(std::uint32_t step, const OrderChains& chains, Trail& trail) const;
  bool apply(std::uint32_t step, std::uint32_t position, const OrderChains& chains, Trail& trail) const;

  std::vector<Step> steps_;
  std::size_t built_ = 0;                            // so many of the steps are in the tables
  GroupedTable<std::uint32_t> always_, guarded_of_;  // the steps of each chain, without a guard and with one
  LiteralTable<std::uint32_t> guarded_;              // the steps of each guard
  std::vector<std::uint32_t> starts_;                // by chain: where its values stand in taken_
  std::vector<std::uint32_t> taken_;                 // by value: 1 + the step that took it first, or kFree
};

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

/// Assigns the only literal of a clause that is not false, if there is only one.

}  // namespace solitaire
