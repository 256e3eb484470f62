#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grouped_table.h"
#include "smt/cdcl/bounds/order_chains.h"
#include "smt/cdcl/trail.h"
#include "smt/sat/cnf.h"
#include "smt/sat/literal_table.h"

namespace solitaire {

/// Finds what follows from linear implications by looking at bounds: the most that a sum can come to is kept
/// up with each change of a bound. If that is too little, the guard does not hold. If the guard holds, an int
/// cannot be so low that the sum would come to too little with the most of all others.
///
/// The clause from which a literal follows has a literal for each int of the sum, so it is made only if
/// somebody asks for it: what was known when the literal was assigned is what stands before it in the trail.
class LinearSums {
 public:
  void add(const LinearImplication& implication, OrderChains& chains);
  void build(std::size_t variables, std::size_t chains);
  bool has_new() const { return built_ < sums_.size(); }
  bool empty() const { return sums_.empty(); }
  template <class Visit>
  void for_each_guard(Visit visit) const {
    for (const Sum& sum : sums_) visit(sum.guard);
  }

  /// Takes note that the bounds of a chain have changed, or that such a change was taken back.
  void note(std::uint32_t chain, const OrderChains::Chain& before, const OrderChains::Chain& after);
  /// Each of these assigns what follows since a bound of a chain has changed, since a guard holds, or at all.
  /// Returns false at once where that is false already.
  bool visit_chain(std::uint32_t chain, const OrderChains& chains, Trail& trail) const {
    return std::ranges::all_of(of_chain_.of(chain),
                               [&](const Place& place) { return apply(place.sum, chains, trail); });
  }
  bool visit_guard(int guard, const OrderChains& chains, Trail& trail) const {
    return std::ranges::all_of(guarded_.of(guard),
                               [&](std::uint32_t sum) { return apply(sum, chains, trail); });
  }
  bool visit_all(const OrderChains& chains, Trail& trail) const {
    for (std::uint32_t sum = 0; sum < sums_.size(); ++sum) {
      if (!apply(sum, chains, trail)) return false;
    }
    return true;
  }

  /// Calls `visit` with literals, all of them false, from which one follows that was assigned by a sum.
  /// is_known(literal) says whether a literal held before that.
  template <class IsKnown, class Visit>
  void explain(std::uint32_t sum, std::uint32_t term, const OrderChains& chains, IsKnown is_known,
               Visit visit) const;

 private:
  /// The weights of a term stand in weights_, one for each of its int's values. They grow with the value, or
  /// fall.
  struct Term {
    std::uint32_t chain, weights;
    bool grows;
  };
  struct Sum {
    int guard;
    std::uint32_t begin, end;  // of its terms
    std::int64_t least;
    std::int64_t most;    // with the bounds as they are
    std::int64_t widest;  // the greatest difference that one term can make
  };
  /// Where a chain stands in a sum.
  struct Place {
    std::uint32_t sum, term;
  };

  static constexpr std::uint32_t kNoTerm =
      static_cast<std::uint32_t>(-1);  // it is the guard that was assigned

  /// Returns the place in the chain of the value with which a term is at its most.
  static std::uint32_t best(const Term& term, const OrderChains::Chain& chain) {
    return term.grows ? chain.limit : chain.reached;
  }
  bool apply(std::uint32_t number, const OrderChains& chains, Trail& trail) const;
  bool apply(std::uint32_t sum, std::uint32_t number, std::int64_t slack, const OrderChains& chains,
             Trail& trail) const;
  bool assign(int literal, std::uint32_t sum, std::uint32_t term, const OrderChains& chains,
              Trail& trail) const;

  std::vector<Sum> sums_;
  std::vector<Term> terms_;
  std::vector<std::int64_t> weights_;
  std::size_t built_ = 0;                // so many of the sums are in the tables
  GroupedTable<Place> of_chain_;         // where each chain stands
  LiteralTable<std::uint32_t> guarded_;  // the sums of each guard
};

template <class IsKnown, class Visit>
void LinearSums::explain(std::uint32_t number, std::uint32_t assigned, const OrderChains& chains,
                         IsKnown is_known, Visit visit) const {
  const Sum& sum = sums_[number];
  if (assigned != kNoTerm) visit(-sum.guard);
  for (std::uint32_t i = sum.begin; i < sum.end; ++i) {
    if (i == assigned) continue;
    const Term& term = terms_[i];
    const OrderChains::Chain& chain = chains[term.chain];
    std::uint32_t at = best(term, chain);
    if (term.grows) {
      while (at < chain.literals.size() && !is_known(-chain.literals[at])) ++at;
      if (at < chain.literals.size()) visit(chain.literals[at]);
    } else {
      while (at > 0 && !is_known(chain.literals[at - 1])) --at;
      if (at > 0) visit(-chain.literals[at - 1]);
    }
  }
}

}  // namespace solitaire
