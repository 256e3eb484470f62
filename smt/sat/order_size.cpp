#include "smt/sat/order_size.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "smt/tuning.h"

namespace solitaire {

OrderSize size_within(Interval interval, std::uint64_t most, std::uint64_t stride) {
  const auto span = static_cast<std::uint64_t>(interval.hi - interval.lo);
  most = std::min(most, span / std::max<std::uint64_t>(stride, 1) + 1);
  return most <= tuning::kMostOrdered ? OrderSize{most, stride} : OrderSize{};
}

OrderSize sum_size(Interval interval, OrderSize a, OrderSize b) {
  const std::uint64_t pairs = a.most * b.most;
  if (pairs == 0 || pairs > tuning::kMostOrderedSum) return {};
  return size_within(interval, pairs, std::gcd(a.stride, b.stride));
}

OrderSize compared_sum_size(Interval interval, OrderSize a, OrderSize b, std::uint64_t comparisons) {
  const std::uint64_t pairs = a.most * b.most;
  if (pairs == 0 || pairs > tuning::kMostComparedSum) return {};
  if (pairs > tuning::kComparedPairs * comparisons) return {};
  return size_within(interval, pairs, std::gcd(a.stride, b.stride));
}

OrderSize product_size(Interval interval, const Sized& a, const Sized& b) {
  const bool has_constant = a.interval.single() || b.interval.single();
  if (!has_constant || !a.size.is_ordered() || !b.size.is_ordered()) return {};
  return size_within(interval, a.size.most * b.size.most, 1);
}

OrderSize quotient_size(Interval interval, const Sized& a, const Sized& b) {
  if (!b.size.is_ordered() || !b.interval.single() || b.interval.lo <= 0) return {};
  return size_within(interval, a.size.most, 1);
}

OrderSize either_size(Interval interval, const Sized& a, const Sized& b) {
  if (!a.size.is_ordered() || !b.size.is_ordered()) return {};
  const auto offset = static_cast<std::uint64_t>(std::abs(a.interval.lo - b.interval.lo));
  const OrderSize size = size_within(interval, a.size.most + b.size.most,
                                     std::gcd(std::gcd(a.size.stride, b.size.stride), offset));
  return size.most <= tuning::kMostOrderedOfTwo ? size : OrderSize{};
}

}  // namespace solitaire
