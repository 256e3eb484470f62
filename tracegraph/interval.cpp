#include "tracegraph/interval.h"

#include <array>
#include <bit>

#include "base/floor_division.h"

namespace solitaire {
namespace {

__extension__ using Wide = __int128;

std::int64_t saturate(Wide value) {
  return static_cast<std::int64_t>(std::clamp<Wide>(value, -Wide{kIntLimit} - 1, Wide{kIntLimit} + 1));
}

Interval saturate(Wide lo, Wide hi) { return {saturate(lo), saturate(hi)}; }

/// Quotients by a divisor of one sign are monotone in both operands, so the corners bound them.
Interval divide_by_one_sign(Interval a, Interval b) {
  const std::array corners = {floor_divide(a.lo, b.lo), floor_divide(a.lo, b.hi), floor_divide(a.hi, b.lo),
                              floor_divide(a.hi, b.hi)};
  const auto [lo, hi] = std::minmax_element(corners.begin(), corners.end());
  return {*lo, *hi};
}

Interval modulo_positive(Interval a, Interval b) {
  if (a.lo >= 0 && a.hi < b.lo) return a;
  if (b.single() && floor_divide(a.lo, b.lo) == floor_divide(a.hi, b.lo)) {
    const std::int64_t turns = floor_divide(a.lo, b.lo) * b.lo;
    return {a.lo - turns, a.hi - turns};
  }
  return {0, a.lo >= 0 ? std::min(a.hi, b.hi - 1) : b.hi - 1};
}

/// Applies `part` to the negative and to the positive values of b, and joins what they give.
template <class Part>
Interval over_nonzero(Interval b, Part part) {
  const bool negative = b.lo < 0;
  const bool positive = b.hi > 0;
  if (!negative && !positive) return {0, 0};
  const Interval below{b.lo, std::min<std::int64_t>(b.hi, -1)};
  const Interval above{std::max<std::int64_t>(b.lo, 1), b.hi};
  if (!negative) return part(above);
  if (!positive) return part(below);
  return hull(part(below), part(above));
}

}  // namespace

int bit_width(Interval interval) {
  const auto bits = [](std::int64_t value) {  // of a value that is not negative
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
  };
  if (interval.lo >= 0) return std::max(1, bits(interval.hi));
  return 1 + std::max(bits(-(interval.lo + 1)), interval.hi > 0 ? bits(interval.hi) : 0);
}

Interval add(Interval a, Interval b) { return saturate(Wide{a.lo} + b.lo, Wide{a.hi} + b.hi); }
Interval subtract(Interval a, Interval b) { return saturate(Wide{a.lo} - b.hi, Wide{a.hi} - b.lo); }
Interval negate(Interval a) { return {-a.hi, -a.lo}; }

Interval multiply(Interval a, Interval b) {
  const std::array<Wide, 4> corners = {Wide{a.lo} * b.lo, Wide{a.lo} * b.hi, Wide{a.hi} * b.lo,
                                       Wide{a.hi} * b.hi};
  const auto [lo, hi] = std::minmax_element(corners.begin(), corners.end());
  return saturate(*lo, *hi);
}

Interval divide(Interval a, Interval b) {
  return over_nonzero(b, [a](Interval part) { return divide_by_one_sign(a, part); });
}

Interval modulo(Interval a, Interval b) {
  return over_nonzero(b, [a](Interval part) {
    // a mod -n is -((-a) mod n): the remainder of floor division takes the divisor's sign.
    return part.lo > 0 ? modulo_positive(a, part) : negate(modulo_positive(negate(a), negate(part)));
  });
}

Interval minimum(Interval a, Interval b) { return {std::min(a.lo, b.lo), std::min(a.hi, b.hi)}; }
Interval maximum(Interval a, Interval b) { return {std::max(a.lo, b.lo), std::max(a.hi, b.hi)}; }

Interval absolute(Interval a) {
  if (a.lo >= 0) return a;
  if (a.hi <= 0) return negate(a);
  return {0, std::max(-a.lo, a.hi)};
}

}  // namespace solitaire
