// Laws that hold for every row of the operation table: folding, intervals, simplification and the encoding of
// each solver all say the same. They loop over the table, so an operation that is added is tested, and fails
// until `means` below knows it.
#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <vector>
#include <z3++.h>

#include "smt/nearby_then_cadical.h"
#include "smt/operation_rows.h"
#include "smt/sat/cadical_solver.h"
#include "smt/unsupported_operation.h"
#include "smt/write_smtlib.h"
#include "smt/z3/z3_solver.h"
#include "tests/solve/proof.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

__extension__ using Wide = __int128;
using Result = std::optional<Scalar>;

/// Operations that look up a table have tests of their own, in allowed_test.cpp.
template <class Visit>
void each_operation(Visit visit) {
  for (std::size_t i = 0; i < kOpCount; ++i) {
    const Operation& row = operation(static_cast<Op>(i));
    if (row.fold != nullptr && !has_table(row.op)) visit(row);
  }
}

bool on_ints(const Operation& row) { return row.operand != Type::kFloat && row.result != Type::kFloat; }
Type operand_type(const Operation& row, std::size_t number) {
  return is_ite(row.op) && number == 0 ? Type::kBool : row.operand;
}

/// All ways to take one of each list.
template <class T>
void each_tuple(const std::vector<std::vector<T>>& lists, const std::function<void(const T*)>& visit) {
  std::vector<T> tuple(lists.size());
  const std::function<void(std::size_t)> fill = [&](std::size_t at) {
    if (at == lists.size()) return visit(tuple.data());
    for (const T& each : lists[at]) {
      tuple[at] = each;
      fill(at + 1);
    }
  };
  fill(0);
}

std::vector<Scalar> edge_values(Type type) {
  std::vector<Scalar> values;
  if (type == Type::kBool) return {Scalar::of(false), Scalar::of(true)};
  if (type == Type::kFloat) {
    for (const double each : {-1e300, -2.5, -1.0, -0.0, 0.0, 0.5, 1.0, 2.0, 2.5, 9007199254740992.0, 1e300}) {
      values.push_back(Scalar::of(each));
    }
    return values;
  }
  for (const int power : {3, 8, 16, 31, 32, 53, 61}) {
    for (const int off : {-1, 0, 1}) {
      values.push_back(Scalar::of((std::int64_t{1} << power) + off));
      values.push_back(Scalar::of(-(std::int64_t{1} << power) + off));
    }
  }
  for (std::int64_t i = -5; i <= 5; ++i) values.push_back(Scalar::of(i));
  for (const std::int64_t i : {kIntLimit, kIntLimit - 1}) {
    values.push_back(Scalar::of(i));
    values.push_back(Scalar::of(-i));
  }
  return values;
}

bool is_int(Result result, Wide wanted) {
  const bool fits = -Wide{kIntLimit} <= wanted && wanted <= Wide{kIntLimit};
  return result.has_value() == fits && (!fits || result->i == wanted);
}
bool is_bool(Result result, bool wanted) { return result && result->i == (wanted ? 1 : 0); }
bool is_finite(Result result, double wanted) {
  return result.has_value() == std::isfinite(wanted) && (!result || result->f == wanted);
}
bool is_float(Result result, double wanted) {
  return result && (result->f == wanted || (std::isnan(result->f) && std::isnan(wanted)));
}

/// Quotient q of a by b: the rest a - q * b has the sign of b and is nearer to 0 than b.
bool is_rest(Wide rest, Wide b) { return rest == 0 || (b > 0 ? 0 < rest && rest < b : b < rest && rest < 0); }

bool near(double a, double b) {
  return a == b || std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// Powers by repeated multiplication where the exponent is a small whole number, and by the sign and the
/// logarithm of the result elsewhere.
bool means_power(double base, double exponent, Result result) {
  const bool whole = std::floor(exponent) == exponent;
  if (base < 0 && !whole) return !result;
  if (!result) return false;
  if (whole && std::abs(exponent) <= 8) {
    double product = 1;
    for (int i = 0; i < static_cast<int>(std::abs(exponent)); ++i) product *= base;
    return near(result->f, exponent < 0 ? 1 / product : product);
  }
  const double logarithm = exponent * std::log(std::abs(base));
  if (logarithm > 709.7) return std::isinf(result->f);
  if (logarithm < -700) return std::abs(result->f) < 1e-300;
  return near(std::abs(result->f), std::exp(logarithm));
}

/// The angle of the direction (x, y) from the x axis: its cosine and sine point that way.
bool means_angle(double y, double x, double angle) {
  const double length = std::hypot(x, y);
  if (!(std::abs(angle) <= 3.1415926535897936)) return false;
  if (length == 0) return true;
  return std::abs(std::cos(angle) - x / length) <= 1e-9 && std::abs(std::sin(angle) - y / length) <= 1e-9;
}

/// Whether `result` is what the operation means, said independently of how the table computes it.
bool means(Op op, const Scalar* x, Result result) {
  const Wide a = x[0].i, b = x[1].i;
  const double f = x[0].f, g = x[1].f;
  switch (op) {
    case Op::kNot:
      return is_bool(result, a == 0);
    case Op::kAnd:
      return is_bool(result, a + b == 2);
    case Op::kOr:
      return is_bool(result, a + b >= 1);
    case Op::kEqBool:
      return is_bool(result, a + b != 1);
    case Op::kIteBool:
    case Op::kIteInt:
      return result && result->i == (a == 1 ? x[1].i : x[2].i);
    case Op::kAdd:
      return is_int(result, a + b);
    case Op::kSub:
      return is_int(result, a - b);
    case Op::kMul:
      return is_int(result, a * b);
    case Op::kDiv:
      return b == 0 ? !result : result && is_rest(a - b * result->i, b);
    case Op::kMod:
      return b == 0 ? !result : result && is_rest(result->i, b) && (a - result->i) % b == 0;
    case Op::kNeg:
      return is_int(result, 0 - a);
    case Op::kMin:
      return result && (result->i == a || result->i == b) && result->i <= a && result->i <= b;
    case Op::kMax:
      return result && (result->i == a || result->i == b) && result->i >= a && result->i >= b;
    case Op::kAbs:
      return result && result->i >= 0 && (result->i == a || result->i == -a);
    case Op::kEqInt:
      return is_bool(result, a - b == 0);
    case Op::kLtInt:
      return is_bool(result, b - a > 0);
    case Op::kLeInt:
      return is_bool(result, b - a >= 0);
    case Op::kToFloat:
      return is_float(result, static_cast<double>(x[0].i));
    case Op::kFloor:
      if (!result) return !(std::abs(f) <= 9007199254740992.0);
      return static_cast<double>(result->i) <= f && f - static_cast<double>(result->i) < 1;
    case Op::kAddFloat:
      return is_finite(result, f + g);
    case Op::kSubFloat:
      return is_finite(result, f - g);
    case Op::kMulFloat:
      return is_finite(result, f * g);
    case Op::kDivFloat:
      return g == 0 ? !result : is_finite(result, f / g);
    case Op::kNegFloat:
      return is_float(result, 0 - f);
    case Op::kMinFloat:
      return result && (result->f == f || result->f == g) && result->f <= f && result->f <= g;
    case Op::kMaxFloat:
      return result && (result->f == f || result->f == g) && result->f >= f && result->f >= g;
    case Op::kExp:  // the sign and the growth of it; its exact value is what log undoes
      return result && result->f >= 0 && (f > 700 || f < -700 || near(std::log(result->f), f));
    case Op::kLog:
      return f <= 0 ? !result : result && near(std::exp(result->f / 2) * std::exp(result->f / 2), f);
    case Op::kPow:
      return means_power(f, g, result);
    case Op::kLgamma:  // the recurrence Gamma(x + 1) = x Gamma(x), and a pole where Gamma has one
      if (!result) return (f <= 0 && f == std::floor(f)) || std::abs(f) > 1e300;
      return f < 1e-3 || f > 100 || near(std::exp(std::lgamma(f + 1) - result->f), f);
    case Op::kAtan2:
      return result && means_angle(f, g, result->f);
    case Op::kSqrt:
      return f < 0 ? !result : result && std::abs(result->f * result->f - f) <= 1e-15 * f;
    case Op::kSin:
      return result && std::abs(result->f) <= 1 && result->f == std::sin(f);
    case Op::kCos:
      return result && std::abs(result->f) <= 1 && result->f == std::cos(f);
    case Op::kIteFloat:
      return is_float(result, a == 1 ? x[1].f : x[2].f);
    case Op::kEqFloat:
      return is_bool(result, !(f < g) && !(f > g));
    case Op::kLtFloat:
      return is_bool(result, g > f);
    case Op::kLeFloat:
      return is_bool(result, !(f > g));
    default:
      FAIL("say here what ", operation(op).name, " means");
      return false;
  }
}

TEST_CASE("folding: every operation gives what it means, at the edges too") {
  each_operation([](const Operation& row) {
    std::vector<std::vector<Scalar>> values;
    for (std::size_t i = 0; i < row.arity; ++i) values.push_back(edge_values(operand_type(row, i)));
    std::size_t wrong = 0;
    each_tuple<Scalar>(values, [&](const Scalar* tuple) {
      Scalar operands[3] = {};
      std::copy_n(tuple, row.arity, operands);
      if (means(row.op, operands, row.fold(operands))) return;
      if (++wrong < 4) FAIL_CHECK(row.name, " of ", operands[0].i, ", ", operands[1].i, ", ", operands[2].i);
    });
    CHECK(wrong == 0);
  });
}

TEST_CASE("commutativity: the table says of exactly those operations that their operands can change places") {
  each_operation([](const Operation& row) {
    if (row.arity != 2) return;
    bool commutes = true;
    each_tuple<Scalar>({edge_values(row.operand), edge_values(row.operand)}, [&](const Scalar* tuple) {
      const Scalar swapped[2] = {tuple[1], tuple[0]};
      const Result one = row.fold(tuple);
      const Result other = row.fold(swapped);
      // Bit for bit, by which the smaller of -0.0 and 0.0 depends on the order.
      commutes = commutes && one.has_value() == other.has_value() && (!one || one->i == other->i);
    });
    CAPTURE(row.name);
    CHECK(row.commutative == commutes);
  });
}

/// The central difference over a step that suits the operand's size; nothing where the function is undefined
/// on either side.
std::optional<double> slope(const Operation& row, const Scalar* at, std::size_t number) {
  Scalar below[3] = {at[0], at[1], at[2]}, above[3] = {at[0], at[1], at[2]};
  const double step = 1e-6 * std::max(1.0, std::abs(at[number].f));
  below[number].f -= step;
  above[number].f += step;
  const Result low = row.fold(below);
  const Result high = row.fold(above);
  if (!low || !high) return std::nullopt;
  return (high->f - low->f) / (above[number].f - below[number].f);
}

TEST_CASE("derivatives: those of the table are the slopes of the folds") {
  std::mt19937_64 random(3);
  each_operation([&](const Operation& row) {
    if (row.derivative == nullptr) return;
    int compared = 0;
    for (int round = 0; round < 400; ++round) {
      Scalar operands[3] = {};
      for (std::size_t i = 0; i < row.arity; ++i) {
        operands[i] = Scalar::of(static_cast<double>(random() % 8000) / 1000 - 4 + 0.0003);
        if (operand_type(row, i) == Type::kBool) operands[i] = Scalar::of(random() % 2 == 0);
      }
      const Result result = row.fold(operands);
      if (!result) continue;
      double partials[3] = {};
      row.derivative(operands, result->f, partials);
      for (std::size_t i = 0; i < row.arity; ++i) {
        if (operand_type(row, i) != Type::kFloat) continue;
        const auto expected = slope(row, operands, i);
        if (!expected) continue;
        CAPTURE(row.name);
        CAPTURE(operands[0].f);
        CAPTURE(operands[1].f);
        CHECK(partials[i] == doctest::Approx(*expected).epsilon(1e-4));
        ++compared;
      }
    }
    CHECK(compared > 100);
  });
}

// ---- intervals

Interval hull_of(const Operation& row, const Interval* operands) {
  std::vector<std::vector<std::int64_t>> values(row.arity);
  for (std::size_t i = 0; i < row.arity; ++i) {
    for (std::int64_t v = operands[i].lo; v <= operands[i].hi; ++v) values[i].push_back(v);
  }
  std::optional<Interval> hull;
  each_tuple<std::int64_t>(values, [&](const std::int64_t* tuple) {
    Scalar scalars[3] = {};
    for (std::size_t i = 0; i < row.arity; ++i) scalars[i] = Scalar::of(tuple[i]);
    const Result result = row.fold(scalars);
    if (result) hull = solitaire::hull(hull.value_or(Interval{result->i, result->i}), {result->i, result->i});
  });
  return hull.value_or(Interval{0, 0});
}

TEST_CASE(
    "intervals: exactly the values that small operands give; of a remainder by several divisors at least "
    "those") {
  each_operation([](const Operation& row) {
    if (row.bounds == nullptr || row.operand != Type::kInt) return;
    std::vector<std::vector<Interval>> operands;
    for (std::size_t i = 0; i < row.arity; ++i) {
      operands.emplace_back();
      if (operand_type(row, i) == Type::kBool) operands.back() = {{0, 1}};
      for (std::int64_t lo = -5; lo <= 5 && operands.back().size() != 1; ++lo) {
        for (std::int64_t hi = lo; hi <= 5; ++hi) operands.back().push_back({lo, hi});
      }
    }
    std::size_t wrong = 0;
    each_tuple<Interval>(operands, [&](const Interval* tuple) {
      const Interval bounds = row.bounds(tuple);
      const Interval exact = hull_of(row, tuple);
      const bool loose = row.op == Op::kMod && !tuple[1].single();
      if (loose ? hull(bounds, exact) == bounds : bounds == exact) return;
      if (++wrong < 4)
        FAIL_CHECK(row.name, " gives ", bounds.lo, "..", bounds.hi, ", not ", exact.lo, "..", exact.hi);
    });
    CHECK(wrong == 0);
  });
}

std::int64_t value_within(Interval interval, std::mt19937_64& random) {
  switch (random() % 4) {
    case 0:
      return interval.lo;
    case 1:
      return interval.hi;
    default: {
      const auto count = static_cast<std::uint64_t>(interval.hi - interval.lo) + 1;
      return interval.lo + static_cast<std::int64_t>(random() % count);
    }
  }
}

TEST_CASE("intervals: no value of large operands lies outside, up to the exact range") {
  std::mt19937_64 random(1);
  const std::vector<Scalar> edges = edge_values(Type::kInt);
  each_operation([&](const Operation& row) {
    if (row.bounds == nullptr) return;
    for (int round = 0; round < 3000; ++round) {
      Interval intervals[3];
      Scalar operands[3];
      for (std::size_t i = 0; i < row.arity; ++i) {
        const std::int64_t one = edges[random() % edges.size()].i, other = edges[random() % edges.size()].i;
        intervals[i] = {std::min(one, other), std::max(one, other)};
        operands[i] = Scalar::of(value_within(intervals[i], random));
        if (operand_type(row, i) == Type::kBool) operands[i] = Scalar::of(random() % 2 == 0);
        if (operand_type(row, i) == Type::kFloat)
          operands[i] = Scalar::of(static_cast<double>(operands[i].i) / 3);
      }
      const Result result = row.fold(operands);
      const Interval bounds = row.bounds(intervals);
      CAPTURE(row.name);
      if (result) REQUIRE(bounds.contains(result->i));
      // A sum or product that leaves the exact range is announced by its interval.
      if (!result && row.op != Op::kDiv && row.op != Op::kMod && row.op != Op::kFloor)
        REQUIRE(!bounds.exact());
    }
  });
}

TEST_CASE("bit_width: the fewest bits that hold the interval") {
  const auto fits = [](Interval interval, int width) {
    const Wide all = Wide{1} << width;
    if (interval.lo >= 0) return interval.hi < all;
    return -all / 2 <= interval.lo && interval.hi < all / 2;
  };
  const std::vector<Scalar> edges = edge_values(Type::kInt);
  for (const Scalar lo : edges) {
    for (const Scalar hi : edges) {
      if (lo.i > hi.i) continue;
      const Interval interval{lo.i, hi.i};
      const int width = bit_width(interval);
      REQUIRE(fits(interval, width));
      REQUIRE((width == 1 || !fits(interval, width - 1)));
    }
  }
}

// ---- the graph

/// A random DAG over a few choices, beside the plain meaning of each node under a number of assignments.
class Sketch {
 public:
  Sketch(std::uint64_t seed, bool with_floats) : random_(seed), with_floats_(with_floats) {
    const Distribution domains[] = {{-3, 2, 1, {}}, {0, 1, 1, {}}, {4, 8, 1, {}}, {-8, 7, 5, {}}};
    for (const Distribution& domain : domains) {
      variables.push_back(
          graph.choice({addresses.site(addresses.root(), std::to_string(variables.size())), domain}));
      values_.emplace_back();
      for (std::int64_t v = domain.lo; v <= domain.hi; v += domain.step) values_.back().push_back(v);
    }
    for (int i = 0; i < kAssignments; ++i) {
      assignments.emplace_back();
      for (const auto& domain : values_) assignments.back().push_back(domain[random_() % domain.size()]);
    }
    for (std::size_t i = 0; i < variables.size(); ++i) {
      std::vector<Result> meaning;
      for (const auto& assignment : assignments) meaning.emplace_back(Scalar::of(assignment[i]));
      add(variables[i], Type::kInt, std::move(meaning));
    }
    for (const std::int64_t each : {-2, -1, 0, 1, 3}) {
      add(graph.constant(each), Type::kInt, std::vector<Result>(kAssignments, Scalar::of(each)));
    }
    add(kTrue, Type::kBool, std::vector<Result>(kAssignments, Scalar::of(true)));
    add(kFalse, Type::kBool, std::vector<Result>(kAssignments, Scalar::of(false)));
    if (with_floats)
      add(graph.constant(1.5), Type::kFloat, std::vector<Result>(kAssignments, Scalar::of(1.5)));
  }

  /// Applies a random operation to random nodes.
  void grow() {
    const Operation& row = operation(static_cast<Op>(random_() % kOpCount));
    if (row.fold == nullptr || has_table(row.op) || (!with_floats_ && !on_ints(row))) return grow();
    std::array<std::size_t, 3> operands{};
    for (std::size_t i = 0; i < row.arity; ++i) operands[i] = some(operand_type(row, i));
    std::vector<Result> meaning;
    for (int i = 0; i < kAssignments; ++i)
      meaning.push_back(meaning_of(row, operands, static_cast<std::size_t>(i)));
    try {
      const NodeId node = apply(row, operands);
      CHECK(node == apply(row, operands));  // the same expression is the same node
      add(node, row.result, std::move(meaning));
    } catch (const IntegerTooLarge&) {
      // Announced by the interval; the evaluator reports it.
    } catch (const UndefinedOperation&) {
      for (const Result& each : meaning) CHECK(!each);
    }
  }

  struct Known {
    NodeId node;
    Type type;
    std::vector<Result> meaning;  // by assignment
  };

  static constexpr int kAssignments = 24;
  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> variables;
  std::vector<std::vector<std::int64_t>> assignments;
  std::vector<Known> known;

 private:
  void add(NodeId node, Type type, std::vector<Result> meaning) {
    known.push_back({node, type, std::move(meaning)});
  }

  std::size_t some(Type type) {
    while (true) {
      const std::size_t i = random_() % known.size();
      if (known[i].type == type) return i;
    }
  }

  NodeId apply(const Operation& row, const std::array<std::size_t, 3>& at) {
    const auto node = [&](std::size_t i) { return known[at[i]].node; };
    if (row.arity == 1) return graph.apply(row.op, {node(0)});
    if (row.arity == 2) return graph.apply(row.op, {node(0), node(1)});
    return graph.apply(row.op, {node(0), node(1), node(2)});
  }

  /// As the evaluator has it: what is not taken or does not matter need not have a value.
  Result meaning_of(const Operation& row, const std::array<std::size_t, 3>& at,
                    std::size_t assignment) const {
    const auto value = [&](std::size_t i) { return known[at[i]].meaning[assignment]; };
    if (is_ite(row.op)) return value(0) ? value(value(0)->i != 0 ? 1 : 2) : std::nullopt;
    Scalar operands[3] = {};
    for (std::size_t i = 0; i < row.arity; ++i) {
      if (!value(i)) return std::nullopt;
      operands[i] = *value(i);
    }
    return row.fold(operands);
  }

  std::mt19937_64 random_;
  bool with_floats_;
  std::vector<std::vector<std::int64_t>> values_;
};

TEST_CASE("graph: folding, simplifying and ordering operands change no value, and intervals hold it") {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Sketch sketch(seed, true);
    for (int i = 0; i < 120; ++i) sketch.grow();
    for (std::size_t i = 0; i < sketch.assignments.size(); ++i) {
      Assignment assignment(
          sketch.graph, [&](std::size_t variable) { return Scalar::of(sketch.assignments[i][variable]); });
      for (const Sketch::Known& known : sketch.known) {
        const Result& wanted = known.meaning[i];
        if (!wanted) continue;
        const Result found = assignment.value(known.node);
        CAPTURE(seed);
        REQUIRE(found);
        if (known.type == Type::kFloat) {
          REQUIRE((found->f == wanted->f || std::isnan(wanted->f)));
        } else {
          REQUIRE(found->i == wanted->i);
        }
        if (known.type == Type::kInt) REQUIRE(sketch.graph.node(known.node).interval.contains(wanted->i));
      }
    }
  }
}

TEST_CASE("graph: a comparison of what is chosen is about the sides that it does not settle") {
  Graph graph;
  AddressTable addresses;
  const auto choice = [&](const char* name, std::int64_t lo, std::int64_t hi) {
    return graph.choice({addresses.site(addresses.root(), name), {lo, hi, 1, {}}});
  };
  const NodeId c = graph.apply(Op::kLtInt, {choice("c", 0, 1), graph.constant(std::int64_t{1})});
  const NodeId x = choice("x", 0, 9), y = choice("y", 0, 9);
  const NodeId one = graph.constant(std::int64_t{1}), zero = graph.constant(std::int64_t{0});
  const NodeId length = graph.phi(c, graph.apply(Op::kSub, {x, y}), one);
  const auto both = [&](NodeId a, NodeId b) { return graph.conjunction(a, b); };
  CHECK(graph.apply(Op::kLeInt, {length, zero}) == both(c, graph.apply(Op::kLeInt, {x, y})));
  CHECK(graph.apply(Op::kLtInt, {zero, length}) ==
        graph.disjunction(graph.negation(c), graph.apply(Op::kLtInt, {y, x})));
  const NodeId five = graph.constant(std::int64_t{5});
  // Where it settles neither side, it stays as it is.
  CHECK(graph.node(graph.apply(Op::kLeInt, {graph.phi(c, x, y), five})).op == Op::kLeInt);
  NodeId chain = x;  // deeper than it is looked into: it stays as it is, and comes to its end
  for (int i = 0; i < 5000; ++i)
    chain = graph.phi(graph.apply(Op::kLtInt, {choice(std::to_string(i).c_str(), 0, 1), one}), one, chain);
  CHECK(graph.node(graph.apply(Op::kLeInt, {chain, zero})).op == Op::kLeInt);
}

TEST_CASE("graph: that a list's element is a constant is a condition on the index") {
  Graph graph;
  AddressTable addresses;
  const NodeId index = graph.choice({addresses.site(addresses.root(), "index"), {0, 199, 1, {}}});
  const auto is = [&](std::int64_t place) { return graph.apply(Op::kEqInt, {index, graph.constant(place)}); };
  const auto element = [&](std::int64_t places) {
    NodeId chosen = graph.constant(places % 10);
    for (std::int64_t i = places - 1; i >= 0; --i) chosen = graph.phi(is(i), graph.constant(i % 10), chosen);
    return chosen;
  };
  for (const std::int64_t places :
       {199, 150}) {  // all but the last of the index's values have a place, or fewer
    const NodeId last = graph.apply(Op::kEqInt, {element(places), graph.constant(places % 10)});
    for (std::int64_t value = 0; value < 200; ++value) {
      Assignment assignment(graph, [&](std::size_t) { return Scalar::of(value); });
      CHECK(assignment.holds(last) == (std::min(value, places) % 10 == places % 10));
    }
  }
  CHECK(graph.apply(Op::kEqInt, {graph.phi(is(3), graph.constant(std::int64_t{7}), element(199)),
                                 graph.constant(std::int64_t{10})}) == kFalse);
  NodeId expected = kFalse;
  for (std::int64_t i = 9; i < 200; i += 10) expected = graph.disjunction(expected, is(i));
  CHECK(graph.apply(Op::kEqInt, {element(199), graph.constant(std::int64_t{9})}) == expected);
}

TEST_CASE("graph: hash-consing finds equal expressions, whichever way round their operands stand") {
  Graph graph;
  AddressTable addresses;
  const NodeId x = graph.choice({addresses.site(addresses.root(), "x"), {0, 9, 1, {}}});
  const NodeId y = graph.choice({addresses.site(addresses.root(), "y"), {0, 9, 1, {}}});
  const NodeId three = graph.constant(std::int64_t{3});
  CHECK(graph.apply(Op::kAdd, {x, y}) == graph.apply(Op::kAdd, {y, x}));
  CHECK(graph.apply(Op::kSub, {x, three}) == graph.apply(Op::kAdd, {graph.constant(std::int64_t{-3}), x}));
  CHECK(graph.apply(Op::kEqInt, {graph.apply(Op::kAdd, {x, three}), graph.constant(std::int64_t{5})}) ==
        graph.apply(Op::kEqInt, {graph.constant(std::int64_t{2}), x}));
  CHECK(graph.apply(Op::kLtInt, {x, graph.constant(std::int64_t{10})}) == kTrue);
  CHECK(graph.phi(graph.apply(Op::kLtInt, {x, y}), x, x) == x);
  const NodeId is_three = graph.apply(Op::kEqInt, {x, three});
  const NodeId is_four = graph.apply(Op::kEqInt, {x, graph.constant(std::int64_t{4})});
  const NodeId is_y = graph.apply(Op::kEqInt, {x, y});
  CHECK(graph.conjunction(is_three, is_four) == kFalse);
  CHECK(graph.conjunction(graph.negation(is_four), is_three) == is_three);
  CHECK(graph.conjunction(is_four, graph.negation(is_three)) == is_four);
  CHECK(graph.conjunction(is_four, graph.negation(is_y)) != is_four);
  CHECK(graph.conjunction(is_four, is_y) != kFalse);
  const std::size_t size = graph.size();
  for (std::int64_t i = 0; i < 5000; ++i) graph.apply(Op::kMul, {x, graph.constant(i + 2)});
  for (std::int64_t i = 0; i < 5000; ++i) graph.apply(Op::kMul, {graph.constant(i + 2), x});
  CHECK(graph.size() <= size + 10'000);  // a constant and a product each, and none twice
}

// ---- the solvers

struct Z3 {
  static std::unique_ptr<Solver> make(const Graph& graph, const AddressTable& addresses) {
    return make_z3_solver(graph, addresses, {});
  }
};
struct Cadical {
  static std::unique_ptr<Solver> make(const Graph& graph, const AddressTable&) {
    return make_cadical_solver(graph);
  }
};

const Distribution kDomains[] = {
    {0, 1, 1, {}},      {0, 3, 1, {}},       {0, 4, 1, {}},   {1, 4, 1, {}},     {-3, 2, 1, {}},
    {-4, -1, 1, {}},    {-1, 1, 1, {}},      {-8, -7, 1, {}}, {5, 8, 1, {}},     {-4, 3, 1, {}},
    {-7, 2, 3, {}},     {10, 14, 2, {}},     {-5, 5, 5, {}},  {127, 129, 1, {}}, {-129, -127, 1, {}},
    {0, 1000, 250, {}}, {-128, 127, 51, {}},
};

std::vector<std::int64_t> values_of(const Distribution& domain) {
  std::vector<std::int64_t> values;
  for (std::int64_t v = domain.lo; v <= domain.hi; v += domain.step) values.push_back(v);
  return values;
}

/// A graph of a few choices, for asking a solver about.
struct Puzzle {
  NodeId choice(const Distribution& domain) {
    variables.push_back(
        graph.choice({addresses.site(addresses.root(), std::to_string(variables.size())), domain}));
    return variables.back();
  }
  NodeId is(NodeId node, std::int64_t value) {
    return graph.apply(Op::kEqInt, {node, graph.constant(value)});
  }
  NodeId is(NodeId node, Scalar value) {
    if (graph.node(node).type() == Type::kBool) return value.i != 0 ? node : graph.negation(node);
    return is(node, value.i);
  }
  template <class BackEnd>
  bool possible(NodeId condition) {
    const auto solver = BackEnd::make(graph, addresses);
    solver->add_clause({&condition, 1});
    return solver->check({}, never) == Verdict::kSatisfiable;
  }

  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> variables;
  StopSignal never;
};

TEST_CASE_TEMPLATE("solver: a choice takes the values of its domain, each and no other", BackEnd, Z3,
                   Cadical) {
  for (const Distribution& domain : kDomains) {
    Puzzle puzzle;
    const NodeId x = puzzle.choice(domain);
    const NodeId known = puzzle.graph.apply(Op::kLeInt, {x, puzzle.choice({-2000, 2000, 1, {}})});
    const auto solver = BackEnd::make(puzzle.graph, puzzle.addresses);
    solver->add_clause({&known, 1});
    std::vector<std::int64_t> found;
    while (solver->check({}, puzzle.never) == Verdict::kSatisfiable && found.size() < 1000) {
      found.push_back(solver->value(0));
      const NodeId other = puzzle.graph.negation(puzzle.is(x, found.back()));
      solver->add_clause({&other, 1});
    }
    std::sort(found.begin(), found.end());
    CHECK(found == values_of(domain));
  }
}

/// Under which values of the operands the encoding and the fold differ, over all operations; or kFalse.
NodeId difference(Puzzle& puzzle, const std::vector<Distribution>& domains, std::optional<Op> only) {
  Graph& graph = puzzle.graph;
  std::vector<std::vector<std::int64_t>> values;
  for (const Distribution& domain : domains) values.push_back(values_of(domain));
  NodeId differ = kFalse;
  each_operation([&](const Operation& row) {
    if (!on_ints(row) || row.arity > domains.size() || (only && row.op != *only)) return;
    std::array<NodeId, 3> operands{};
    for (std::size_t i = 0; i < row.arity; ++i) {
      const NodeId variable = puzzle.variables[i];
      operands[i] = operand_type(row, i) == Type::kBool ? puzzle.is(variable, domains[i].lo) : variable;
    }
    NodeId result{};
    try {
      result = row.arity == 1   ? graph.apply(row.op, {operands[0]})
               : row.arity == 2 ? graph.apply(row.op, {operands[0], operands[1]})
                                : graph.apply(row.op, {operands[0], operands[1], operands[2]});
    } catch (const IntegerTooLarge&) {
      return;
    }
    each_tuple<std::int64_t>({values.begin(), values.begin() + row.arity}, [&](const std::int64_t* tuple) {
      Scalar scalars[3] = {};
      NodeId here = kTrue;
      for (std::size_t i = 0; i < row.arity; ++i) {
        const bool as_bool = operand_type(row, i) == Type::kBool;
        scalars[i] = as_bool ? Scalar::of(tuple[i] == domains[i].lo) : Scalar::of(tuple[i]);
        here = graph.conjunction(here, puzzle.is(puzzle.variables[i], tuple[i]));
      }
      const Result wanted = row.fold(scalars);
      if (!wanted) return;
      differ = graph.disjunction(differ, graph.conjunction(here, graph.negation(puzzle.is(result, *wanted))));
    });
  });
  return differ;
}

template <class BackEnd>
void check_encoding(const std::vector<Distribution>& domains) {
  Puzzle puzzle;
  for (const Distribution& domain : domains) puzzle.choice(domain);
  if (!puzzle.possible<BackEnd>(difference(puzzle, domains, std::nullopt))) return;
  each_operation([&](const Operation& row) {
    if (!on_ints(row) || !puzzle.possible<BackEnd>(difference(puzzle, domains, row.op))) return;
    FAIL_CHECK(row.name, " of ", domains[0].lo, "..", domains[0].hi, " and ", domains[1].lo, "..",
               domains[1].hi);
  });
}

TEST_CASE_TEMPLATE(
    "solver: the encoding of every operation agrees with its fold, over pairs of domains (slow)", BackEnd, Z3,
    Cadical) {
  for (const Distribution& a : kDomains) {
    for (const Distribution& b : kDomains) check_encoding<BackEnd>({a, b});
  }
}

TEST_CASE_TEMPLATE("solver: the encoding of every operation agrees with its fold, over triples of domains",
                   BackEnd, Z3, Cadical) {
  for (const std::size_t first : {4, 10}) {
    for (const std::size_t second : {1, 4, 5, 11}) {
      for (const std::size_t third : {3, 9, 13})
        check_encoding<BackEnd>({kDomains[first], kDomains[second], kDomains[third]});
    }
  }
}

TEST_CASE_TEMPLATE("solver: the encoding holds out to the ends of the exact range (slow)", BackEnd, Z3,
                   Cadical) {
  const Distribution top{kIntLimit - 1, kIntLimit, 1, {}}, bottom{-kIntLimit, -kIntLimit + 1, 1, {}};
  const Distribution half{(std::int64_t{1} << 61) - 1, std::int64_t{1} << 61, 1, {}};
  const Distribution whole{-kIntLimit, kIntLimit, kIntLimit, {}};
  const Distribution sign{-1, 1, 1, {}}, small{2, 3, 1, {}};
  const std::pair<Distribution, Distribution> pairs[] = {{top, bottom},   {top, sign},  {bottom, sign},
                                                         {bottom, small}, {half, half}, {whole, half}};
  for (const auto& [a, b] : pairs) check_encoding<BackEnd>({a, b});
}

TEST_CASE_TEMPLATE("solver: random expressions come out as their operations fold", BackEnd, Z3, Cadical) {
  for (std::uint64_t seed = 1000; seed < 1120; ++seed) {
    Sketch sketch(seed, false);
    for (int i = 0; i < 60; ++i) sketch.grow();
    Graph& graph = sketch.graph;
    NodeId differ = kFalse;
    for (std::size_t i = 0; i < 8; ++i) {
      NodeId here = kTrue;
      for (std::size_t v = 0; v < sketch.variables.size(); ++v) {
        const NodeId value = graph.constant(sketch.assignments[i][v]);
        here = graph.conjunction(here, graph.apply(Op::kEqInt, {sketch.variables[v], value}));
      }
      NodeId wrong = kFalse;
      for (const Sketch::Known& known : sketch.known) {
        if (!known.meaning[i]) continue;
        const std::int64_t wanted = known.meaning[i]->i;
        const NodeId equal = known.type == Type::kBool
                                 ? (wanted != 0 ? known.node : graph.negation(known.node))
                                 : graph.apply(Op::kEqInt, {known.node, graph.constant(wanted)});
        wrong = graph.disjunction(wrong, graph.negation(equal));
      }
      differ = graph.disjunction(differ, graph.conjunction(here, wrong));
    }
    const StopSignal never;
    const auto solver = BackEnd::make(graph, sketch.addresses);
    solver->add_clause({&differ, 1});
    CAPTURE(seed);
    REQUIRE(solver->check({}, never) == Verdict::kUnsatisfiable);
  }
}

TEST_CASE_TEMPLATE("solver: a core names assumptions that cannot hold together, and nothing if none matters",
                   BackEnd, Z3, Cadical) {
  Puzzle puzzle;
  const NodeId x = puzzle.choice({0, 9, 1, {}}), y = puzzle.choice({0, 9, 1, {}});
  const NodeId low = puzzle.graph.apply(Op::kLtInt, {x, puzzle.graph.constant(std::int64_t{3})});
  const NodeId high = puzzle.graph.apply(Op::kLtInt, {puzzle.graph.constant(std::int64_t{5}), x});
  const NodeId aside = puzzle.is(y, 4);
  const auto solver = BackEnd::make(puzzle.graph, puzzle.addresses);
  const NodeId assumed[] = {aside, low, high};
  REQUIRE(solver->check(assumed, puzzle.never) == Verdict::kUnsatisfiable);
  const std::vector<NodeId> core = solver->core();
  CHECK(core.size() == 2);
  CHECK(std::find(core.begin(), core.end(), aside) == core.end());
  CHECK(solver->check({assumed, 2}, puzzle.never) == Verdict::kSatisfiable);  // an assumption does not stay
  solver->add_clause({});
  REQUIRE(solver->check(assumed, puzzle.never) == Verdict::kUnsatisfiable);
  CHECK(solver->core().empty());
}

TEST_CASE_TEMPLATE("solver: a stop signal ends a check", BackEnd, Z3, Cadical) {
  Puzzle puzzle;
  puzzle.never.request();
  const NodeId condition = puzzle.is(puzzle.choice({0, 9, 1, {}}), 3);
  const auto solver = BackEnd::make(puzzle.graph, puzzle.addresses);
  CHECK(solver->check({&condition, 1}, puzzle.never) == Verdict::kStopped);
}

// ---- formulas as SMT-LIB

/// Decides a script by two solvers that share no code with each other or with what wrote it.
std::string verdict_on(const std::string& smt2) {
  const std::string verdict = cvc5_verdict(smt2);
  z3::context context;
  z3::solver solver(context);
  solver.from_string(smt2.c_str());
  const z3::check_result z3_verdict = solver.check();
  CHECK(verdict == (z3_verdict == z3::sat ? "sat" : z3_verdict == z3::unsat ? "unsat" : "unknown"));
  return verdict;
}

TEST_CASE("smtlib: what is written of every operation agrees with its fold (slow)") {
  const Distribution whole{-kIntLimit, kIntLimit, kIntLimit, {}}, sign{-1, 1, 1, {}};
  const Distribution top{kIntLimit - 1, kIntLimit, 1, {}}, bottom{-kIntLimit, -kIntLimit + 1, 1, {}};
  std::vector<std::vector<Distribution>> cases = {{top, bottom}, {whole, sign}};
  for (const std::size_t first : {4, 10}) {
    for (const std::size_t second : {5, 11})
      cases.push_back({kDomains[first], kDomains[second], kDomains[3]});
  }
  for (const std::vector<Distribution>& domains : cases) {
    Puzzle puzzle;
    for (const Distribution& domain : domains) puzzle.choice(domain);
    const NodeId differ = difference(puzzle, domains, std::nullopt);
    CAPTURE(domains[0].lo);
    CAPTURE(domains[1].lo);
    CHECK(verdict_on(to_smt2(puzzle.graph, puzzle.addresses, {{differ}})) == "unsat");
  }
}

TEST_CASE("smtlib: a choice has the values of its domain, each and no other, as the solvers have it") {
  for (const Distribution& domain : kDomains) {
    for (const std::int64_t value : {domain.lo, domain.lo + 1, domain.hi - 1, domain.hi}) {
      Puzzle puzzle;
      const NodeId x = puzzle.choice(domain), y = puzzle.choice({-2000, 2000, 1, {}});
      const NodeId conditions[] = {puzzle.graph.apply(Op::kEqInt, {x, y}), puzzle.is(y, value)};
      const NodeId both = puzzle.graph.conjunction(conditions[0], conditions[1]);
      CAPTURE(domain.lo);
      CAPTURE(value);
      CHECK(domain.contains(value) == puzzle.possible<Cadical>(both));
      CHECK(verdict_on(to_smt2(puzzle.graph, puzzle.addresses, conditions)) ==
            (domain.contains(value) ? "sat" : "unsat"));
    }
  }
}

TEST_CASE("smtlib: random conditions are decided as the operations fold") {
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    Sketch sketch(seed, false);
    for (int i = 0; i < 40; ++i) sketch.grow();
    std::vector<NodeId> wanted;  // what holds under the first assignment
    for (std::size_t v = 0; v < sketch.variables.size(); ++v) {
      const NodeId value = sketch.graph.constant(sketch.assignments[0][v]);
      wanted.push_back(sketch.graph.apply(Op::kEqInt, {sketch.variables[v], value}));
    }
    NodeId last = kTrue;
    for (const Sketch::Known& known : sketch.known) {
      if (known.type != Type::kBool || !known.meaning[0]) continue;
      last = known.meaning[0]->i != 0 ? known.node : sketch.graph.negation(known.node);
      wanted.push_back(last);
    }
    CAPTURE(seed);
    CHECK(verdict_on(to_smt2(sketch.graph, sketch.addresses, wanted)) == "sat");
    wanted.push_back(sketch.graph.negation(last));
    CHECK(verdict_on(to_smt2(sketch.graph, sketch.addresses, wanted)) == "unsat");
  }
}

TEST_CASE("solver: an operation is refused that the operation table puts on floats, and no other") {
  for (std::size_t i = 0; i < kOpCount; ++i) {
    const Op op = static_cast<Op>(i);
    CHECK(has_bits(op) == !operation(op).on_floats());
  }
}

TEST_CASE("solver: conditions on floats are refused, by the operation that bits cannot express") {
  Puzzle puzzle;
  const NodeId as_float = puzzle.graph.apply(Op::kToFloat, {puzzle.choice({0, 9, 1, {}})});
  const NodeId condition = puzzle.graph.apply(Op::kLtFloat, {as_float, puzzle.graph.constant(2.5)});
  const auto refused_by = [&](const std::function<void()>& action) {
    try {
      action();
    } catch (const UnsupportedOperation& error) {
      return error.node;
    }
    return kTrue;
  };
  const auto refusal_of = [&](Solver& solver) {
    return refused_by([&] { solver.add_clause({&condition, 1}); });
  };
  CHECK(refusal_of(*make_cadical_solver(puzzle.graph)) == condition);
  CHECK(refusal_of(*make_nearby_then_cadical(puzzle.graph, {})) == condition);
  CHECK(refusal_of(*make_z3_solver(puzzle.graph, puzzle.addresses, {})) == condition);
  CHECK(refused_by([&] { to_smt2(puzzle.graph, puzzle.addresses, {&condition, 1}); }) == condition);
}

}  // namespace
}  // namespace solitaire
