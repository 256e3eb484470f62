#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/grouped_table.h"
#include "smt/cdcl/bounds/order_chains.h"
#include "smt/cdcl/trail.h"
#include "smt/sat/cnf.h"
#include "smt/sat/literal_table.h"

namespace solitaire {

/// Finds what follows from order implications by looking at bounds. An order implication stands for a clause
/// for each value; of these, only the one at the bound can make new literals follow.
///
/// For example, let x and y be ints from 0 to 9, and x <= y. That is an order implication of 9 clauses: x >=
/// 1 implies y >= 1, up to x >= 9 implies y >= 9. Once x >= 5 holds, the fifth clause gives y >= 5. The first
/// four say nothing more, and the last four nothing yet.
///
/// Each clause that is applied is one of the order implication, or follows from one because the
/// literals of a chain hold in order. It need not follow from clauses that the solver knows: whatever values
/// the choices have, a model can give each literal of a chain the value that it stands for.
class OrderImplications {
 public:
  void add(const OrderImplication& order_implication, OrderChains& chains);
  void build(std::size_t variables, std::size_t chains);
  bool has_new() const { return built_ < steps_.size(); }
  template <class Visit>
  void for_each_guard(Visit visit) const {
    for (const Step& step : steps_) visit(step.guard);
  }

  /// Each of these looks at what follows since the lowest value left of a chain has grown, since the highest
  /// has fallen, or since a guard holds. host.apply(a, b, c) assigns what follows from a clause, and returns
  /// false if the clause is broken; then so do these, at once.
  bool visit_raised(std::uint32_t chain, const OrderChains& chains, Trail& trail) const {
    return std::ranges::all_of(
        as_lower_.of(chain), [&](std::uint32_t step) { return apply_reached(steps_[step], chains, trail); });
  }
  bool visit_lowered(std::uint32_t chain, const OrderChains& chains, Trail& trail) const {
    return std::ranges::all_of(as_upper_.of(chain),
                               [&](std::uint32_t step) { return apply_limit(steps_[step], chains, trail); });
  }
  bool visit_guard(int guard, const OrderChains& chains, Trail& trail) const {
    return std::ranges::all_of(guarded_.of(guard), [&](std::uint32_t step) {
      return apply_reached(steps_[step], chains, trail) && apply_limit(steps_[step], chains, trail);
    });
  }

 private:
  /// An order implication, whose chains are given by their numbers.
  struct Step {
    int guard;
    std::uint32_t lower, upper;
    std::uint32_t first, base, count;
  };

  static bool apply_reached(const Step& step, const OrderChains& chains, Trail& trail);
  static bool apply_limit(const Step& step, const OrderChains& chains, Trail& trail);

  std::vector<Step> steps_;
  std::size_t built_ = 0;                            // so many of the steps are in the tables
  GroupedTable<std::uint32_t> as_lower_, as_upper_;  // the steps of each chain
  LiteralTable<std::uint32_t> guarded_;              // the steps of each guard
};

/// have it, the guard does not hold.

/// that already, the guard does not hold.

}  // namespace solitaire
