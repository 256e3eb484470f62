#include "smt/sat/unary_sum.h"

#include <algorithm>
#include <bit>
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

UnarySum::UnarySum(OrderEncodedInt term, std::size_t most_pairs)
    : most_pairs_(most_pairs),
      values_(term.values),
      step_(values_.size() == 2 ? values_[1] - values_[0] : 0),
      term_(std::make_unique<OrderEncodedInt>(std::move(term))) {}

UnarySum::UnarySum(std::unique_ptr<UnarySum> one, std::unique_ptr<UnarySum> other)
    : most_pairs_(one->most_pairs_),
      values_(sums_of(one->values_, other->values_)),
      step_(one->step_ == other->step_ ? one->step_ : 0),
      one_(std::move(one)),
      other_(std::move(other)) {}

std::optional<UnarySum> UnarySum::of(const LinearBound& bound, Limits limits) {
  std::size_t left = limits.clauses;
  std::vector<std::unique_ptr<UnarySum>> sums;
  for (const auto& [of, factor] : bound.terms)
    sums.push_back(std::unique_ptr<UnarySum>(new UnarySum(scaled(*of, factor), limits.pairs)));
  while (sums.size() > 1) {
    std::vector<std::unique_ptr<UnarySum>> larger;
    for (std::size_t i = 0; i + 1 < sums.size(); i += 2) {
      const std::size_t clauses = most_clauses(*sums[i], *sums[i + 1]);
      if (clauses > left) return std::nullopt;
      left -= clauses;
      larger.push_back(std::unique_ptr<UnarySum>(new UnarySum(std::move(sums[i]), std::move(sums[i + 1]))));
    }
    if (sums.size() % 2 != 0) larger.push_back(std::move(sums.back()));
    sums = std::move(larger);
  }
  return std::move(*sums.front());
}

std::size_t UnarySum::most_clauses(const UnarySum& one, const UnarySum& other) {
  const std::size_t all = one.values_.size() + other.values_.size();
  return is_counted(one, other) ? all * 2 * std::bit_width(all) : one.values_.size() * other.values_.size();
}

/// Returns true if a sum is a large count.
bool UnarySum::is_counted(const UnarySum& one, const UnarySum& other) {
  return one.values_.size() * other.values_.size() > one.most_pairs_ && one.step_ != 0 &&
         one.step_ == other.step_;
}

Literal UnarySum::at_least(Circuit& circuit, std::int64_t bound) {
  return reaches(circuit,
                 static_cast<std::size_t>(std::ranges::lower_bound(values_, bound) - values_.begin()));
}

/// Returns the literal that says that the sum is no less than the value at that position.
Literal UnarySum::reaches(Circuit& circuit, std::size_t position) {
  if (position == 0) return kTrueLiteral;
  if (position == values_.size()) return kFalseLiteral;
  if (term_) return term_->reaches(position);
  if (const auto known = reached_.find(position); known != reached_.end()) return known->second;
  const Literal made = is_counted(*one_, *other_)
                           ? merged(circuit, {one_.get(), 1, one_->values_.size() - 1},
                                    {other_.get(), 1, other_->values_.size() - 1}, 1, position)
                           : by_pairs(circuit, values_[position]);
  return reached_[position] = made;
}

/// For each value that the one half has at most, the other half has to come to the rest.
Literal UnarySum::by_pairs(Circuit& circuit, std::int64_t least) {
  Literal all = kTrueLiteral;
  for (std::size_t i = 0; i < one_->values_.size() && all != kFalseLiteral; ++i) {
    const Literal rest = other_->at_least(circuit, least - one_->values_[i]);
    all = circuit.conjunction(all, circuit.disjunction(one_->reaches(circuit, i + 1), rest));
  }
  return all;
}

/// Of the values reached, half stand at odd places, and one more if their number is odd, in either strand. So
/// the odd ones of both are as many as the even ones or up to two more.
Literal UnarySum::merged(Circuit& circuit, Strand one, Strand other, std::size_t stride, std::size_t number) {
  if (number == 0) return kTrueLiteral;
  if (number > one.count + other.count) return kFalseLiteral;
  const Merged asked{one.first, other.first, stride, number};
  if (const auto known = merged_.find(asked); known != merged_.end()) return known->second;
  const auto odd = [&](std::size_t n) { return merged(circuit, one.odd(), other.odd(), 2 * stride, n); };
  const auto even = [&](std::size_t n) {
    return merged(circuit, one.even(stride), other.even(stride), 2 * stride, n);
  };
  const std::size_t half = number / 2;
  Literal made;
  if (one.count * other.count <= most_pairs_) {
    made = merged_by_pairs(circuit, one, other, stride, number);
  } else if (number % 2 == 0) {
    made = circuit.disjunction(even(half), odd(half + 1));
  } else {
    made = number == 1 ? odd(1) : circuit.conjunction(even(half), odd(half + 1));
  }
  return merged_[asked] = made;
}

Literal UnarySum::merged_by_pairs(Circuit& circuit, Strand one, Strand other, std::size_t stride,
                                  std::size_t number) {
  const auto reached = [&](Strand strand, std::size_t n) {
    if (n > strand.count) return kFalseLiteral;
    return n == 0 ? kTrueLiteral : strand.of->reaches(circuit, strand.first + (n - 1) * stride);
  };
  Literal all = kTrueLiteral;
  for (std::size_t i = 0; i <= std::min(one.count, number - 1) && all != kFalseLiteral; ++i)
    all = circuit.conjunction(all, circuit.disjunction(reached(one, i + 1), reached(other, number - i)));
  return all;
}

}  // namespace solitaire
