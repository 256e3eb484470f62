#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "smt/cdcl/bounds/linear_sums.h"
#include "smt/cdcl/bounds/order_chains.h"
#include "smt/cdcl/bounds/order_differences.h"
#include "smt/cdcl/bounds/order_implications.h"
#include "smt/cdcl/trail.h"
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

  /// Assigns what follows from sums before anything is assigned. Returns false if one cannot come to enough.
  bool visit_all(Trail& trail) const { return sums_.visit_all(chains_, trail); }
  /// Takes note that a literal holds, and assigns what follows. Returns false if a clause is broken.
  bool visit(int assigned, Trail& trail);

  /// The clause of a difference, by which a literal was assigned.
  OrderDifferences::Clause clause_of_difference(std::uint32_t step, std::uint32_t position) const {
    return differences_.clause(step, position, chains_);
  }
  /// Calls `visit` with literals, all of them false, from which one follows that was assigned by a sum.
  template <class IsKnown, class Visit>
  void explain_by_sum(std::uint32_t sum, std::uint32_t term, IsKnown is_known, Visit visit) const {
    sums_.explain(sum, term, chains_, is_known, visit);
  }

  /// undo_level() takes back what bounds have changed since the begin_level() that goes with it.
  void begin_level() { levels_.push_back(chains_.changes()); }
  void undo_level();

 private:
  OrderChains chains_;
  OrderImplications implications_;
  OrderDifferences differences_;
  LinearSums sums_;
  std::vector<std::size_t> levels_;  // how often a bound was changed before each
};

template <class Visit>
void OrderBounds::for_each_literal(Visit visit) const {
  implications_.for_each_guard(visit);
  differences_.for_each_guard(visit);
  sums_.for_each_guard(visit);
  for (std::uint32_t i = 0; i < chains_.size(); ++i) std::ranges::for_each(chains_[i].literals, visit);
}

}  // namespace solitaire
