#include "engines/solve/conclusions/sum_conflict.h"

#include <algorithm>
#include <set>
#include <vector>

#include "engines/solve/conclusions/linear_facts.h"
#include "engines/solve/conclusions/relaxation.h"
#include "engines/tuning.h"
#include "smt/z3/linear_contradiction.h"

namespace solitaire {
namespace {

/// Leaves out facts that cannot take part in a contradiction.
class Reduction {
 public:
  explicit Reduction(const LinearFacts& linear)
      : linear_(linear), wanted_(linear.unknowns().size()), is_left_(linear.facts().size(), true) {
    for (const LinearFact& fact : linear_.facts()) count(fact, 1);
  }

  /// Returns the numbers of the facts that are left.
  std::vector<std::size_t> left() {
    for (bool fewer = true; fewer;) {
      fewer = false;
      for (std::size_t i = 0; i < is_left_.size(); ++i) {
        if (!is_left_[i] || !always_holds(linear_.facts()[i].row)) continue;
        is_left_[i] = false;
        count(linear_.facts()[i], -1);
        fewer = true;
      }
    }
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < is_left_.size(); ++i) {
      if (is_left_[i]) numbers.push_back(i);
    }
    return numbers;
  }

 private:
  /// How many of the facts that are left want an unknown to be small, and how many large.
  struct Wanted {
    int small = 0, large = 0;
  };

  void count(const LinearFact& fact, int by) {
    for (const LinearTerm& term : fact.row.terms) {
      Wanted& wanted = wanted_[term.unknown];
      (term.factor > 0 ? wanted.small : wanted.large) += by;
    }
  }

  /// Returns true if the row holds whatever those unknowns are that other facts want otherwise.
  bool always_holds(const LinearRow& row) const {
    std::int64_t sum = 0;
    for (const LinearTerm& term : row.terms) {
      const Interval range = linear_.unknowns()[term.unknown].range;
      const Wanted& wanted = wanted_[term.unknown];
      const bool is_low = wanted.large == 0 || (wanted.small > 0 && term.factor < 0);
      sum += term.factor * (is_low ? range.lo : range.hi);
    }
    return sum <= row.most;
  }

  const LinearFacts& linear_;
  std::vector<Wanted> wanted_;  // by unknown
  std::vector<bool> is_left_;   // by fact
};

/// The sum of multiples of facts. It has no solution if `least` is more than `most`.
class Total {
 public:
  explicit Total(const LinearFacts& linear) : linear_(linear), factors_(linear.unknowns().size()) {}

  /// Returns false if a number becomes too large.
  bool add(const LinearFact& fact, std::int64_t times) {
    if (times == 0) return true;
    used_.push_back(&fact);
    std::int64_t most = 0;
    if (__builtin_mul_overflow(times, fact.row.most, &most)) return false;
    std::int64_t& part = most < 0 ? needed_ : available_;
    if (__builtin_add_overflow(part, most < 0 ? -most : most, &part)) return false;
    for (const LinearTerm& term : fact.row.terms) {
      std::int64_t more = 0, &factor = factors_[term.unknown];
      if (__builtin_mul_overflow(times, term.factor, &more)) return false;
      if (__builtin_add_overflow(factor, more, &factor)) return false;
    }
    return true;
  }

  /// Returns the conflict, if the sum is one.
  std::optional<OverFull> conflict(Graph& graph) {
    std::vector<SignedNode> because;
    for (const LinearFact* fact : used_)
      because.insert(because.end(), fact->because.begin(), fact->because.end());
    for (std::size_t i = 0; i < factors_.size(); ++i) {
      if (factors_[i] == 0) continue;
      const Unknown& unknown = linear_.unknowns()[i];
      const auto& end = factors_[i] > 0 ? unknown.low : unknown.high;
      std::int64_t least = 0;
      if (__builtin_mul_overflow(factors_[i], factors_[i] > 0 ? unknown.range.lo : unknown.range.hi, &least))
        return std::nullopt;
      std::int64_t& part = least < 0 ? available_ : needed_;
      if (__builtin_add_overflow(part, least < 0 ? -least : least, &part)) return std::nullopt;
      because.insert(because.end(), end.begin(), end.end());
    }
    if (needed_ <= available_) return std::nullopt;
    return OverFull{nodes_of(graph, because), used_.size(), needed_, available_, OverFull::Measure::kSum};
  }

 private:
  static std::vector<NodeId> nodes_of(Graph& graph, const std::vector<SignedNode>& because) {
    std::set<std::uint32_t> nodes;
    for (const SignedNode& each : because)
      nodes.insert((each.holds ? each.node : graph.negation(each.node)).index);
    std::vector<NodeId> conditions;
    for (const std::uint32_t index : nodes) conditions.push_back({index});
    return conditions;
  }

  const LinearFacts& linear_;
  std::vector<std::int64_t> factors_;  // by unknown
  std::vector<const LinearFact*> used_;
  std::int64_t needed_ = 0, available_ = 0;  // the sum of the unknowns' terms is at most their difference
};

std::size_t terms_of(const std::vector<LinearRow>& rows) {
  std::size_t terms = 0;
  for (const LinearRow& row : rows) terms += row.terms.size();
  return terms;
}

}  // namespace

std::optional<OverFull> find_sum_conflict(Graph& graph, std::span<const SignedNode> comparisons) {
  LinearFacts linear(graph);
  for (const SignedNode& comparison : comparisons) linear.add(comparison);
  linear.complete();
  const std::vector<std::size_t> left = Reduction(linear).left();
  std::vector<LinearRow> rows;
  for (const std::size_t number : left) rows.push_back(linear.facts()[number].row);
  if (rows.empty() || terms_of(rows) > tuning::kMostLinearTerms) return std::nullopt;
  std::vector<Interval> ranges;
  for (const Unknown& unknown : linear.unknowns()) ranges.push_back(unknown.range);
  if (has_point(rows, ranges)) return std::nullopt;
  const auto multipliers = find_contradiction(rows, ranges);
  if (!multipliers) return std::nullopt;
  Total total(linear);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (!total.add(linear.facts()[left[i]], (*multipliers)[i])) return std::nullopt;
  }
  return total.conflict(graph);
}

}  // namespace solitaire
