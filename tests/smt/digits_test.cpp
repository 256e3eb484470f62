// Equalities of codes such as y * w + x against all values of their ints.
#include "smt/sat/digits.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "smt/nearby_then_cadical.h"
#include "tracegraph/graph.h"

namespace solitaire {
namespace {

/// A sum of multiples of random ints, and a constant.
class Code {
 public:
  /// `terms` random ints with factors from `factors`.
  Code(std::mt19937_64& random, std::size_t terms, const std::vector<std::int64_t>& factors) {
    const auto from_to = [&](std::int64_t lo, std::int64_t hi) {
      return lo + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(hi - lo + 1));
    };
    for (std::size_t i = 0; i < terms; ++i) {
      const std::int64_t lo = from_to(-2, 2);
      const AddressId address = addresses.site(addresses.root(), std::to_string(i));
      const NodeId drawn = graph.choice({address, Distribution::range(lo, from_to(lo, lo + 4))});
      const std::int64_t factor = factors[i % factors.size()];
      if (!graph.node(drawn).is_constant())
        form.terms.emplace_back(drawn, i < factors.size() ? factor : -factor);
    }
    form.constant = from_to(-2, 2) * factors.back() + from_to(-2, 2);
  }

  /// Calls visit(values) with all values of the ints of the form.
  template <class Visit>
  void for_each_values(Visit visit) const {
    std::vector<std::int64_t> values;
    for (const auto& [node, factor] : form.terms) values.push_back(graph.node(node).interval.lo);
    for (;;) {
      visit(values);
      std::size_t at = 0;
      for (; at < values.size(); ++at) {
        const Interval range = graph.node(form.terms[at].first).interval;
        if (++values[at] <= range.hi) break;
        values[at] = range.lo;
      }
      if (at == values.size()) return;
    }
  }

  std::int64_t sum(const std::vector<std::int64_t>& values) const {
    std::int64_t total = form.constant;
    for (std::size_t i = 0; i < values.size(); ++i) total += form.terms[i].second * values[i];
    return total;
  }

  std::int64_t value_of(NodeId node, const std::vector<std::int64_t>& values) const {
    const auto at = std::ranges::find_if(form.terms, [&](const auto& term) { return term.first == node; });
    return values[static_cast<std::size_t>(at - form.terms.begin())];
  }

  AddressTable addresses;
  Graph graph;
  LinearForm form;
};

}  // namespace

TEST_CASE("digits: all equal exactly where the form is 0") {
  std::mt19937_64 random(1);
  std::size_t apart = 0, shifted = 0;
  for (int round = 0; round < 2000; ++round) {
    const std::vector<std::vector<std::int64_t>> factors = {{1, 4},  {1, 5},  {1, 9},
                                                            {2, 10}, {1, -6}, {1, 5, 25}};
    const auto& drawn = factors[random() % factors.size()];
    const Code code(random, 2 * drawn.size(), drawn);
    const auto digits = equal_digits(code.graph, code.form);
    if (!digits) continue;
    ++apart;
    for (const ShiftedEquality& digit : *digits) shifted += digit.shift != 0 ? 1 : 0;
    code.for_each_values([&](const std::vector<std::int64_t>& values) {
      const bool equal = std::ranges::all_of(*digits, [&](const ShiftedEquality& digit) {
        return code.value_of(digit.a, values) == code.value_of(digit.b, values) + digit.shift;
      });
      REQUIRE(equal == (code.sum(values) == 0));
    });
  }
  CHECK(apart > 300);
  CHECK(shifted > 100);
}

TEST_CASE("digits: a form whose terms overlap has none") {
  AddressTable addresses;
  Graph graph;
  const auto draw = [&](const char* name, std::int64_t hi) {
    return graph.choice({addresses.site(addresses.root(), name), Distribution::range(0, hi)});
  };
  const NodeId y = draw("y", 3), x = draw("x", 4), v = draw("v", 3), u = draw("u", 4);
  const auto with = [&](std::int64_t width) {
    return equal_digits(graph, {{{y, width}, {x, 1}, {v, -width}, {u, -1}}, 0});
  };
  CHECK(with(5));
  CHECK_FALSE(with(4));  // (1, 0) and (0, 4) have the same code
  CHECK_FALSE(equal_digits(graph, {{{y, 5}, {x, 1}, {v, 5}, {u, -1}}, 0}));  // no difference
  CHECK_FALSE(equal_digits(graph, {{{y, 1}, {v, -1}}, 0}));                  // one digit
}

TEST_CASE("digits: solvers find what codes of squares can be") {
  const StopSignal never;
  std::mt19937_64 random(2);
  for (int round = 0; round < 60; ++round) {
    const std::int64_t width = 3 + static_cast<std::int64_t>(random() % 3),
                       moved = static_cast<std::int64_t>(random() % 7) - 3;
    AddressTable addresses;
    Graph graph;
    std::vector<NodeId> choices;
    for (const char* name : {"y", "x", "v", "u"}) {
      const std::int64_t most = name[0] == 'x' || name[0] == 'u' ? width - 1 : 2;
      choices.push_back(graph.choice({addresses.site(addresses.root(), name), Distribution::range(0, most)}));
    }
    const auto code = [&](NodeId row, NodeId column) {
      return graph.apply(Op::kAdd, {graph.apply(Op::kMul, {row, graph.constant(width)}), column});
    };
    const NodeId equal =
        graph.apply(Op::kEqInt, {graph.apply(Op::kAdd, {code(choices[0], choices[1]), graph.constant(moved)}),
                                 code(choices[2], choices[3])});
    for (const bool holds : {true, false}) {
      std::size_t expected = 0, found = 0;
      for (std::int64_t a = 0; a < 3 * width; ++a)
        for (std::int64_t b = 0; b < 3 * width; ++b) expected += (a + moved == b) == holds ? 1 : 0;
      const auto solver = make_nearby_then_cadical(graph, {.seed = 1});
      const NodeId required = holds ? equal : graph.negation(equal);
      solver->add_clause({&required, 1});
      while (solver->check({}, never) == Verdict::kSatisfiable && found <= expected) {
        ++found;
        const auto code_of = [&](std::size_t row) {
          return solver->value(row) * width + solver->value(row + 1);
        };
        REQUIRE((code_of(0) + moved == code_of(2)) == holds);
        std::vector<NodeId> other;
        for (std::size_t i = 0; i < choices.size(); ++i) {
          const NodeId same = graph.apply(Op::kEqInt, {choices[i], graph.constant(solver->value(i))});
          other.push_back(graph.negation(same));
        }
        solver->add_clause(other);
      }
      REQUIRE(found == expected);
    }
  }
}

}  // namespace solitaire
