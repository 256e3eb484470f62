#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "smt/cdcl/bounds/linear_sums.h"
#include "smt/cdcl/bounds/order_chains.h"
#include "smt/cdcl/bounds/order_differences.h"
#include "smt/cdcl/bounds/order_implications.h"
#include "smt/sat/cnf.h"

namespace solitaire {

/// Finds what follows from conditions on ints in order encoding by looking at their bounds, as a finite
/// domain solver does, and not clause by clause. Each kind of condition has a class of its own, and all share
/// the chains. To learn from conflicts, nothing more is needed than the clause from which a literal follows.
class OrderBounds {
 public:
  /// These add a condition, of which nothing follows until build() is called.
  void add(const OrderImplication& implication) { implications_.add(implication, chains_); }
  void add(const OrderDifference& difference) { differences_.add(difference, chains_); }
  void add(const LinearImplication& implication) { sums_.add(implication, chains_); }
  /// Returns true if some were added since build().
  bool has_new() const { return implications_.has_new() || differences_.has_new() || sums_.has_new(); }
  /// Calls `visit` with all literals of the conditions.
  template <class Visit>
  void for_each_literal(Visit visit) const;
  /// Makes the tables, for variables below `variables`. To be called once.
  void build(std::size_t variables);

  /// Looks at what follows from sums before anything is assigned.
  template <class Host>
  bool visit_all(Host& host) const {
    return sums_.visit_all(chains_, host);
  }
  /// Takes note that a literal holds, and has the host assign what follows; see the classes of the conditions
  /// for what it is asked. Returns false if a clause is broken.
  template <class Host>
  bool visit(int assigned, Host& host);

  /// The clause of a difference, by which a literal was assigned.
  OrderDifferences::Clause clause_of_difference(std::uint32_t step, std::uint32_t position) const {
    return differences_.clause(step, position, chains_);
  }
  /// Calls `visit` with literals, all of them false, from which one follows that was assigned by a sum.
  template <class IsKnown, class Visit>
  void explain_by_sum(std::uint32_t sum, std::uint32_t term, IsKnown is_known, Visit visit) const {
    sums_.explain(sum, term, chains_, is_known, visit);
  }

  /// Returns how often a bound was changed. undo_to() takes back the changes after so many.
  std::size_t changes() const { return chains_.changes(); }
  void undo_to(std::size_t changes);

 private:
  OrderChains chains_;
  OrderImplications implications_;
  OrderDifferences differences_;
  LinearSums sums_;
};

template <class Visit>
void OrderBounds::for_each_literal(Visit visit) const {
  implications_.for_each_guard(visit);
  differences_.for_each_guard(visit);
  sums_.for_each_guard(visit);
  for (std::uint32_t i = 0; i < chains_.size(); ++i) std::ranges::for_each(chains_[i].literals, visit);
}

template <class Host>
bool OrderBounds::visit(int assigned, Host& host) {
  // Most formulas have conditions of one kind only, and what is empty is not looked at.
  const auto follows = [&](std::uint32_t chain) {
    return (differences_.empty() || differences_.visit_chain(chain, chains_, host)) &&
           (sums_.empty() || sums_.visit_chain(chain, chains_, host));
  };
  for (const OrderChains::Place place : chains_.places(assigned)) {
    const OrderChains::Chain before = chains_[place.chain];
    if (!chains_.raise(place)) continue;
    if (!sums_.empty()) sums_.note(place.chain, before, chains_[place.chain]);
    if (!implications_.visit_raised(place.chain, chains_, host) || !follows(place.chain)) return false;
  }
  for (const OrderChains::Place place : chains_.places(-assigned)) {
    const OrderChains::Chain before = chains_[place.chain];
    if (!chains_.lower(place)) continue;
    if (!sums_.empty()) sums_.note(place.chain, before, chains_[place.chain]);
    if (!implications_.visit_lowered(place.chain, chains_, host) || !follows(place.chain)) return false;
  }
  return implications_.visit_guard(assigned, chains_, host) &&
         (differences_.empty() || differences_.visit_guard(assigned, chains_, host)) &&
         (sums_.empty() || sums_.visit_guard(assigned, chains_, host));
}

}  // namespace solitaire
