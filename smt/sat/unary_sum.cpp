#include "smt/sat/unary_sum.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace solitaire {
namespace {

std::vector<std::int64_t> sums_of(const std::vector<std::int64_t>& a, const std::vector<std::int64_t>& b) {
  std::vector<std::int64_t> sums, with_one, all;
  for (const std::int64_t y : b) {
    with_one = a;
    for (std::int64_t& value : with_one) value += y;
    all.clear();
    std::ranges::set_union(sums, with_one, std::back_inserter(all));
    sums.swap(all);
  }
  return sums;
}

}  // namespace

UnarySum::UnarySum(OrderEncodedInt term)
    : values_(term.values), term_(std::make_unique<OrderEncodedInt>(std::move(term))) {}

UnarySum::UnarySum(std::unique_ptr<UnarySum> one, std::unique_ptr<UnarySum> other)
    : values_(sums_of(one->values_, other->values_)), one_(std::move(one)), other_(std::move(other)) {}

std::optional<UnarySum> UnarySum::of(const LinearBound& bound, std::size_t most) {
  std::vector<std::unique_ptr<UnarySum>> sums;
  for (const auto& [of, factor] : bound.terms)
    sums.push_back(std::unique_ptr<UnarySum>(new UnarySum(scaled(*of, factor))));
  while (sums.size() > 1) {
    std::vector<std::unique_ptr<UnarySum>> larger;
    for (std::size_t i = 0; i + 1 < sums.size(); i += 2) {
      const std::size_t pairs = sums[i]->values_.size() * sums[i + 1]->values_.size();
      if (pairs > most) return std::nullopt;
      most -= pairs;
      larger.push_back(std::unique_ptr<UnarySum>(new UnarySum(std::move(sums[i]), std::move(sums[i + 1]))));
    }
    if (sums.size() % 2 != 0) larger.push_back(std::move(sums.back()));
    sums = std::move(larger);
  }
  return std::move(*sums.front());
}

/// For each value that the one half has at most, the other half has to come to the rest.
Literal UnarySum::at_least(Circuit& circuit, std::int64_t bound) {
  const auto least = std::ranges::lower_bound(values_, bound);
  if (least == values_.begin()) return kTrueLiteral;
  if (least == values_.end()) return kFalseLiteral;
  if (term_) return term_->at_least(*least);
  const auto [known, is_new] = reached_.try_emplace(*least, kTrueLiteral);
  if (!is_new) return known->second;
  Literal all = kTrueLiteral;
  for (auto value = one_->values_.begin(); value != one_->values_.end() && all != kFalseLiteral; ++value) {
    const Literal more = value + 1 == one_->values_.end() ? kFalseLiteral : one_->at_least(circuit, value[1]);
    all = circuit.conjunction(all, circuit.disjunction(more, other_->at_least(circuit, *least - *value)));
  }
  return known->second = all;
}

}  // namespace solitaire
