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

/// What follows from ladders by bounds: of each number it is known how far it reaches and where it ends, and
/// two such bounds decide a comparison. So of a ladder's clauses only the one that says most is looked at.
///
/// What it gives as a clause is one of the ladder or follows from one by the order of its chains. That order
/// is what the literals mean; whether clauses say so, too, does not matter: a model of the choices stays one
/// when every literal gets the value that it means.
class OrderBounds {
 public:
  /// Before build().
  void add(const OrderImplication& order_implication);
  /// Whether there are ladders that build() did not see.
  bool has_new() const { return built_ < steps_.size(); }
  /// Calls with all literals of these.
  template <class Visit>
  void for_each_literal(Visit visit) const;
  /// Once, for variables below `variables`.
  void build(std::size_t variables);

  /// The literal holds. Calls apply(guard, lower, upper) for the clauses "guard and lower imply upper" from
  /// which something may follow, until one returns false; then it does, too. value(literal) is less than 0
  /// for what is false.
  template <class Value, class Apply>
  bool visit(int assigned, Value value, Apply apply);

  /// How often a bound was changed; what came after so many changes can be taken back.
  std::size_t changes() const { return changed_.size(); }
  void undo_to(std::size_t changes);

 private:
  /// A ladder by the numbers of its chains.
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
  /// A chain's bounds as they were.
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
  std::size_t built_ = 0;                                               // of the steps
  std::unordered_map<const std::vector<int>*, std::uint32_t> numbers_;  // of the chains
  std::vector<Chain> chains_;
  LiteralTable<Place> places_;                       // of literals in chains
  GroupedTable<std::uint32_t> as_lower_, as_upper_;  // numbers of steps, by chain
  LiteralTable<std::uint32_t> guarded_;              // the same by guard
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

/// What follows from how far the lower number reaches: beyond what the upper one can be, or what it is at
/// least.
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

/// What follows from where the upper number ends: the lower one is beyond that, or what it is at most.
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
