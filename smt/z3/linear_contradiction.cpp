#include "smt/z3/linear_contradiction.h"

#include <algorithm>
#include <numeric>

#include "smt/tuning.h"
#include "smt/z3/context.h"

namespace solitaire {
namespace {

/// A system of linear inequalities, on which only so much effort is spent.
class LinearSystem {
 protected:
  LinearSystem() {
    z3::params params(context_);
    params.set("rlimit", tuning::kMostLinearEffort);
    params.set("ctrl_c", false);
    solver_.set(params);
  }

  z3::expr number(std::int64_t value) { return context_.real_val(value); }

  /// A constant whose name is the number of those made before.
  z3::expr next_constant(const z3::sort& sort) {
    return {context_, Z3_mk_const(context_, Z3_mk_int_symbol(context_, made_++), sort)};
  }

  Z3Context owned_;
  z3::context& context_ = *owned_;
  z3::solver solver_{context_, "QF_LRA"};
  int made_ = 0;
};

/// The rows themselves.
class Rows : private LinearSystem {
 public:
  Rows(std::span<const LinearRow> rows, std::span<const Interval> ranges) {
    for (const Interval range : ranges) {
      unknowns_.push_back(next_constant(context_.real_sort()));
      solver_.add(unknowns_.back() >= number(range.lo) && unknowns_.back() <= number(range.hi));
    }
    first_row_ = made_;
    for (const LinearRow& row : rows) add(row);
  }

  /// Returns the numbers of rows that cannot hold together, or nothing if all can or the search takes too
  /// long.
  std::vector<std::size_t> conflict() {
    std::vector<std::size_t> numbers;
    if (solver_.check() != z3::unsat) return numbers;
    for (const z3::expr& name : solver_.unsat_core())
      numbers.push_back(static_cast<std::size_t>(name.decl().name().to_int() - first_row_));
    std::ranges::sort(numbers);
    return numbers;
  }

 private:
  void add(const LinearRow& row) {
    z3::expr_vector terms(context_);
    for (const LinearTerm& term : row.terms)
      terms.push_back(number(term.factor) * unknowns_[static_cast<unsigned>(term.unknown)]);
    terms.push_back(number(0));  // Z3 adds up no empty list
    solver_.add(z3::sum(terms) <= number(row.most), next_constant(context_.bool_sort()));
  }

  int first_row_ = 0;
  z3::expr_vector unknowns_{context_};
};

/// The question for multipliers.
class Multipliers : private LinearSystem {
 public:
  Multipliers(std::span<const LinearRow> rows, std::span<const Interval> ranges) : ranges_(ranges) {
    for (std::size_t i = 0; i < ranges.size(); ++i) factors_.emplace_back(context_);  // copies would be one
    least_.push_back(context_.real_val(0));  // Z3 adds up no empty list
    most_.push_back(context_.real_val(0));
    for (const LinearRow& row : rows) add(row);
    // The least that the sum of all rows can be: its factors times the lower ends of the ranges, and less by
    // the ranges' widths where a factor is negative.
    for (std::size_t i = 0; i < ranges_.size(); ++i) add_least(i);
    solver_.add(z3::sum(least_) > z3::sum(most_));
  }

  std::optional<std::vector<std::int64_t>> find() {
    if (solver_.check() != z3::sat) return std::nullopt;
    const z3::model model = solver_.get_model();
    std::vector<std::int64_t> numerators, denominators;
    std::int64_t common = 1;
    for (const z3::expr& multiplier : multipliers_) {
      const z3::expr value = model.eval(multiplier, true);
      std::int64_t numerator = 0, denominator = 1;
      if (Z3_get_numeral_rational_int64(context_, value, &numerator, &denominator) == 0) return std::nullopt;
      if (__builtin_mul_overflow(common / std::gcd(common, denominator), denominator, &common))
        return std::nullopt;
      numerators.push_back(numerator);
      denominators.push_back(denominator);
    }
    for (std::size_t i = 0; i < numerators.size(); ++i) {
      if (__builtin_mul_overflow(numerators[i], common / denominators[i], &numerators[i]))
        return std::nullopt;
    }
    return numerators;
  }

 private:
  z3::expr at_least_zero() {
    const z3::expr made = next_constant(context_.real_sort());
    solver_.add(made >= 0);
    return made;
  }

  void add(const LinearRow& row) {
    const z3::expr multiplier = at_least_zero();
    multipliers_.push_back(multiplier);
    most_.push_back(multiplier * number(row.most));
    for (const LinearTerm& term : row.terms)
      factors_[term.unknown].push_back(multiplier * number(term.factor));
  }

  void add_least(std::size_t unknown) {
    if (factors_[unknown].empty()) return;
    const Interval range = ranges_[unknown];
    const z3::expr factor = z3::sum(factors_[unknown]);
    const z3::expr negative = at_least_zero();
    solver_.add(negative + factor >= 0);
    least_.push_back(factor * number(range.lo) - negative * number(range.hi - range.lo));
  }

  std::span<const Interval> ranges_;
  std::vector<z3::expr> multipliers_;
  std::vector<z3::expr_vector> factors_;  // by unknown: those that it has in the sum
  z3::expr_vector least_{context_}, most_{context_};
};

}  // namespace

/// Multipliers are asked for of those rows alone that Z3 finds to be in conflict: for a roster of 24 nurses
/// and two weeks it sees in 0.02 s that there are none, where the question for multipliers of all rows took
/// more than 25.
std::optional<std::vector<std::int64_t>> find_contradiction(std::span<const LinearRow> rows,
                                                            std::span<const Interval> ranges) {
  return Z3Context::run([&]() -> std::optional<std::vector<std::int64_t>> {
    const std::vector<std::size_t> numbers = Rows(rows, ranges).conflict();
    if (numbers.empty()) return std::nullopt;
    std::vector<LinearRow> in_conflict;
    for (const std::size_t number : numbers) in_conflict.push_back(rows[number]);
    const auto found = Multipliers(in_conflict, ranges).find();
    if (!found) return std::nullopt;
    std::vector<std::int64_t> multipliers(rows.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) multipliers[numbers[i]] = (*found)[i];
    return multipliers;
  });
}

}  // namespace solitaire
