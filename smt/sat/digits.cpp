#include "smt/sat/digits.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "base/floor_division.h"

namespace solitaire {
namespace {

/// Returns a number that differs from the constant by a multiple of the unit, and with which all of the
/// interval lies between -unit and unit. Nothing if there is none.
std::optional<std::int64_t> fitting_share(Interval range, std::int64_t constant, std::int64_t unit) {
  const std::int64_t rest = floor_modulo(constant, unit);
  for (const std::int64_t share : {rest, rest - unit}) {
    if (-unit < range.lo + share && range.hi + share < unit) return share;
  }
  return std::nullopt;
}

/// Takes the lowest digit from a form whose factors are in ascending order of their sizes: terms that come to
/// less than what divides all factors above them. Nothing if there is no digit above it.
std::optional<LinearForm> take_lowest(const Graph& graph, LinearForm& form) {
  std::vector<std::int64_t> units(form.terms.size() + 1);  // what divides all factors from each on
  for (std::size_t i = form.terms.size(); i-- > 0;) units[i] = std::gcd(units[i + 1], form.terms[i].second);
  Interval range{0, 0};
  for (std::size_t i = 0; i + 1 < form.terms.size(); ++i) {
    const auto& [node, factor] = form.terms[i];
    range = add(range, multiply(graph.node(node).interval, {factor, factor}));
    const auto share = fitting_share(range, form.constant, units[i + 1]);
    if (!share) continue;
    const auto end = form.terms.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    LinearForm lowest{{form.terms.begin(), end}, *share};
    form.terms.erase(form.terms.begin(), end);
    form.constant -= *share;
    return lowest;
  }
  return std::nullopt;
}

/// Reads factor * a - factor * b + constant == 0.
std::optional<ShiftedEquality> equality_of(const LinearForm& digit) {
  if (digit.terms.size() != 2) return std::nullopt;
  const auto& [a, factor] = digit.terms[0];
  const auto& [b, other] = digit.terms[1];
  if (other != -factor || digit.constant % factor != 0) return std::nullopt;
  return ShiftedEquality{a, b, -digit.constant / factor};
}

}  // namespace

std::optional<std::vector<ShiftedEquality>> equal_digits(const Graph& graph, LinearForm form) {
  std::ranges::sort(form.terms, {}, [](const auto& term) { return std::abs(term.second); });
  std::vector<LinearForm> digits;
  while (auto lowest = take_lowest(graph, form)) digits.push_back(*std::move(lowest));
  if (digits.empty()) return std::nullopt;
  digits.push_back(std::move(form));
  std::vector<ShiftedEquality> equalities;
  for (const LinearForm& digit : digits) {
    const auto equality = equality_of(digit);
    if (!equality) return std::nullopt;
    equalities.push_back(*equality);
  }
  return equalities;
}

}  // namespace solitaire
