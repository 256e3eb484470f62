#pragma once
#include <algorithm>
#include <cstdint>

namespace solitaire {

/// Every int of the language lies in [-kIntLimit, kIntLimit]; what grows past it is an error, never a wrap.
/// Two such ints can be added in 64 bits without overflow.
inline constexpr std::int64_t kIntLimit = (std::int64_t{1} << 62) - 1;

constexpr bool is_exact(std::int64_t value) { return -kIntLimit <= value && value <= kIntLimit; }

/// All values from lo to hi, both included. An interval that left the exact range saturates just outside it.
struct Interval {
  std::int64_t lo = 0;
  std::int64_t hi = 0;

  constexpr bool single() const { return lo == hi; }
  constexpr bool contains(std::int64_t value) const { return lo <= value && value <= hi; }
  constexpr bool exact() const { return is_exact(lo) && is_exact(hi); }
  friend bool operator==(const Interval&, const Interval&) = default;
};

constexpr Interval hull(Interval a, Interval b) { return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)}; }
constexpr bool disjoint(Interval a, Interval b) { return a.hi < b.lo || b.hi < a.lo; }

/// The fewest bits that hold every value of the interval: unsigned if none is negative, else two's
/// complement.
int bit_width(Interval interval);

Interval add(Interval a, Interval b);
Interval subtract(Interval a, Interval b);
Interval multiply(Interval a, Interval b);
Interval negate(Interval a);
/// Floor division, for a divisor that is not zero: the interval of all quotients by the nonzero values of b.
/// If b holds zero alone there is no quotient; the result is then [0, 0].
Interval divide(Interval a, Interval b);
/// The remainder of floor division (it has the divisor's sign), under the same condition.
Interval modulo(Interval a, Interval b);
Interval minimum(Interval a, Interval b);
Interval maximum(Interval a, Interval b);
Interval absolute(Interval a);

}  // namespace solitaire
