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

}  // namespace solitaire
