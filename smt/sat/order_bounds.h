#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "smt/sat/cnf.h"
#include "smt/sat/grouped_table.h"
#include "smt/sat/literal_table.h"

namespace solitaire {

/// Finds what follows from order implications by looking at bounds. An int in order encoding is a chain of
/// literals, one for each of its values but the lowest, and the literals up to the int's value hold. So two
/// bounds describe what is known of an int: the last literal that holds, and the first one that does not. An
/// order implication stands for a clause for each value; of these, only the one at the bound can make new
/// literals follow.
///
/// For example, let x and y be ints from 0 to 9, and x <= y. That is an order implication of 9 clauses: x >=
/// 1 implies y >= 1, up to x >= 9 implies y >= 9. Once x >= 5 holds, the fifth clause gives y >= 5. The first
/// four say nothing more, and the last four nothing yet.
///
/// Each clause that visit() gives is one of the order implication, or follows from one because the literals
/// of a chain hold in order. It need not follow from clauses that the solver knows: whatever values the
/// choices have, a model can give each literal of a chain the value that it stands for.
class OrderBounds {
 public:
  /// Adds an order implication, of which nothing follows until build() is called.
  void add(const OrderImplication& order_implication);
  /// Returns true if some were added since build().
  bool has_new() const { return built_ < steps_.size(); }
  /// Calls `visit` with all literals of the order implications.
  template <class Visit>
  void for_each_literal(Visit visit) const;
  /// Makes the tables, for variables below `variables`. To be called once.
  void build(std::size_t variables);

  /// Takes note that a literal holds. Calls apply(guard, lower, upper) for each clause "guard and lower imply
  /// upper" from which something may follow. Returns false as soon as one of these calls does. value(literal)
  /// is negative for a literal that is false.
  template <class Value, class Apply>
  bool visit(int assigned, Value value, Apply apply);

  /// Returns how often a bound was changed. undo_to() takes back the changes after so many.
  std::size_t changes() const { return changed_.size(); }
  void undo_to(std::size_t changes);

 private:
  /// An order implication, whose chains are given by their numbers.
  struct Step {
    int guard;
    std::uint32_t lower, upper;
    std::uint32_t first, base, count;
  };
  struct Chain {
    std::span<const int> literals;
    std::uint32_t reached = 0;  // one more than the last place whose literal holds
    std::uint32_t limit = 0;    // the first place whose literal does not hold
  };
  struct Place {
    std::uint32_t chain, position;
  };
  /// The bounds that a chain had before a change.
  struct Bounds {
    std::uint32_t chain, reached, limit;
  };

  bool raise(Place place);
  bool lower(Place place);
  template <class Value, class Apply>
  bool apply_reached(const Step& step, Value value, Apply apply) const;
  template <class Value, class Apply>
  bool apply_limit(const Step& step, Value value, Apply apply) const;

  std::uint32_t chain(const std::vector<int>* literals);

  std::vector<Step> steps_;
  std::size_t built_ = 0;  // so many of the steps are in the tables
  std::unordered_map<const std::vector<int>*, std::uint32_t> numbers_;  // of each chain
  std::vector<Chain> chains_;
  LiteralTable<Place> places_;                       // where each literal stands in chains
  GroupedTable<std::uint32_t> as_lower_, as_upper_;  // the steps of each chain
  LiteralTable<std::uint32_t> guarded_;              // the steps of each guard
  std::vector<Bounds> changed_;
};

template <class Visit>
void OrderBounds::for_each_literal(Visit visit) const {
  for (const Step& step : steps_) visit(step.guard);
  for (const Chain& chain : chains_) std::ranges::for_each(chain.literals, visit);
}

template <class Value, class Apply>
bool OrderBounds::visit(int assigned, Value value, Apply apply) {
  const auto reached = [&](std::uint32_t step) { return apply_reached(steps_[step], value, apply); };
  const auto limit = [&](std::uint32_t step) { return apply_limit(steps_[step], value, apply); };
  for (const Place place : places_.of(assigned)) {
    if (raise(place) && !std::ranges::all_of(as_lower_.of(place.chain), reached)) return false;
  }
  for (const Place place : places_.of(-assigned)) {
    if (lower(place) && !std::ranges::all_of(as_upper_.of(place.chain), limit)) return false;
  }
  for (const std::uint32_t step : guarded_.of(assigned)) {
    if (!reached(step) || !limit(step)) return false;
  }
  return true;
}

/// Applies what follows from the lower int's bound: the upper int has at least some value or, if it cannot
/// have it, the guard does not hold.
template <class Value, class Apply>
bool OrderBounds::apply_reached(const Step& step, Value value, Apply apply) const {
  const Chain& lower = chains_[step.lower];
  const int guard = value(step.guard);
  if (lower.reached <= step.first || guard < 0) return true;
  const Chain& upper = chains_[step.upper];
  const std::uint32_t at = step.base + std::min(lower.reached - 1 - step.first, step.count - 1);
  if (at < upper.limit && guard == 0) return true;
  return apply(step.guard, lower.literals[lower.reached - 1], upper.literals[std::min(at, upper.limit)]);
}

/// Applies what follows from the upper int's bound: the lower int has at most some value or, if it is beyond
/// that already, the guard does not hold.
template <class Value, class Apply>
bool OrderBounds::apply_limit(const Step& step, Value value, Apply apply) const {
  const Chain& upper = chains_[step.upper];
  const int guard = value(step.guard);
  if (upper.limit >= step.base + step.count || guard < 0) return true;
  const Chain& lower = chains_[step.lower];
  const std::uint32_t at = step.first + (upper.limit > step.base ? upper.limit - step.base : 0);
  if (at >= lower.reached && guard == 0) return true;
  return apply(step.guard, lower.literals[at < lower.reached ? lower.reached - 1 : at],
               upper.literals[upper.limit]);
}

}  // namespace solitaire
