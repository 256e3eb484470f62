#include "smt/cdcl/bounds/linear_sums.h"

namespace solitaire {

void LinearSums::add(const LinearImplication& implication, OrderChains& chains) {
  Sum sum{implication.guard, static_cast<std::uint32_t>(terms_.size()), 0, implication.least, 0, 0};
  for (const LinearImplication::Term& term : implication.terms) {
    const bool grows = term.weights.front() <= term.weights.back();
    terms_.push_back({chains.number(term.chain), static_cast<std::uint32_t>(weights_.size()), grows});
    weights_.insert(weights_.end(), term.weights.begin(), term.weights.end());
    const auto [low, high] = std::minmax(term.weights.front(), term.weights.back());
    sum.most += high;
    sum.widest = std::max(sum.widest, high - low);
  }
  sum.end = static_cast<std::uint32_t>(terms_.size());
  sums_.push_back(sum);
}

void LinearSums::build(std::size_t variables, std::size_t chains) {
  built_ = sums_.size();
  of_chain_ = {chains, [this](const auto& put) {
                 for (std::uint32_t i = 0; i < built_; ++i) {
                   for (std::uint32_t term = sums_[i].begin; term < sums_[i].end; ++term)
                     put(terms_[term].chain, Place{i, term});
                 }
               }};
  guarded_ = {variables, [this](const auto& put) {
                for (std::uint32_t i = 0; i < built_; ++i) put(sums_[i].guard, i);
              }};
}

void LinearSums::note(std::uint32_t chain, const OrderChains::Chain& before,
                      const OrderChains::Chain& after) {
  for (const Place& place : of_chain_.of(chain)) {
    const Term& term = terms_[place.term];
    const std::int64_t* const weights = &weights_[term.weights];
    sums_[place.sum].most += weights[best(term, after)] - weights[best(term, before)];
  }
}

bool LinearSums::apply(std::uint32_t number, const OrderChains& chains, Trail& trail) const {
  const Sum& sum = sums_[number];
  const std::int64_t slack = sum.most - sum.least;
  if (slack >= sum.widest) return true;
  const int guard = trail.value(sum.guard);
  if (guard < 0) return true;
  if (slack < 0) return assign(-sum.guard, number, kNoTerm, chains, trail);
  if (guard == 0) return true;
  for (std::uint32_t term = sum.begin; term < sum.end; ++term) {
    if (!apply(number, term, slack, chains, trail)) return false;
  }
  return true;
}

/// Assigns that an int is no worse than at the last value with which the sum can still come to enough.
bool LinearSums::apply(std::uint32_t sum, std::uint32_t number, std::int64_t slack, const OrderChains& chains,
                       Trail& trail) const {
  const Term& term = terms_[number];
  const OrderChains::Chain& chain = chains[term.chain];
  if (chain.reached >= chain.limit) return true;
  const std::int64_t* const weights = &weights_[term.weights];
  const std::int64_t least = weights[best(term, chain)] - slack;
  std::uint32_t at = term.grows ? chain.reached : chain.limit;
  if (weights[at] >= least) return true;
  while (weights[at] < least) at = term.grows ? at + 1 : at - 1;
  return assign(term.grows ? chain.literals[at - 1] : -chain.literals[at], sum, number, chains, trail);
}

/// Assigns what follows from a sum. Returns false if that is false already.
bool LinearSums::assign(int literal, std::uint32_t sum, std::uint32_t term, const OrderChains& chains,
                        Trail& trail) const {
  const int value = trail.value(literal);
  if (value == 0) trail.assign(literal, {Reason::kSum, static_cast<int>(sum), static_cast<int>(term)});
  if (value >= 0) return true;
  std::vector<int> broken{literal};
  const auto holds = [&](int other) { return trail.value(other) > 0; };
  explain(sum, term, chains, holds, [&](int other) { broken.push_back(other); });
  trail.break_clause(broken);
  return false;
}

}  // namespace solitaire
