// What the laws of laws_test.cpp leave open about the path over circuits and clauses: gates that are needed
// in one direction first and in the other later, and CaDiCaL between checks.
#include "smt/sat/bit_blast.h"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "smt/cdcl/enumerator.h"
#include "smt/nearby_then_cadical.h"
#include "smt/sat/cadical_solver.h"
#include "smt/z3/z3_solver.h"
#include "tracegraph/assignment.h"
#include "tracegraph/graph.h"

namespace solitaire {
namespace {

/// Random bool nodes over a few choices.
class Thicket {
 public:
  /// Total: without divisions by what can be zero, of which solvers make what they like.
  Thicket(std::uint64_t seed, bool total, std::vector<Distribution> given)
      : domains(std::move(given)), random_(seed), total_(total) {
    for (const Distribution& domain : domains) {
      const AddressId address = addresses.site(addresses.root(), std::to_string(ints_.size()));
      ints_.push_back(graph.choice({address, domain}));
    }
    for (const std::int64_t each : {-3, 0, 2, 5}) ints_.push_back(graph.constant(each));
    bools_ = {kTrue, kFalse};
  }

  void grow() {
    const auto op = static_cast<Op>(random_() % kOpCount);
    const Operation& row = operation(op);
    if (row.arity == 0 || has_table(op) || row.operand == Type::kFloat || row.result == Type::kFloat)
      return grow();
    const bool ite = op == Op::kIteBool || op == Op::kIteInt;
    const NodeId a = ite ? some(Type::kBool) : some(row.operand);
    const NodeId b = some(row.operand), c = some(row.operand);
    const bool divides = op == Op::kDiv || op == Op::kMod;
    if (total_ && divides && graph.node(b).interval.contains(0)) return;
    try {
      const NodeId made = row.arity == 1   ? graph.apply(op, {a})
                          : row.arity == 2 ? graph.apply(op, {a, b})
                                           : graph.apply(op, {a, b, c});
      if (row.result == Type::kBool || bit_width(graph.node(made).interval) < 12)
        nodes(row.result).push_back(made);
    } catch (const UndefinedOperation&) {
    }
  }

  NodeId some(Type type) { return nodes(type)[random_() % nodes(type).size()]; }
  NodeId condition() {
    const NodeId node = some(Type::kBool);
    return random_() % 2 == 0 ? node : graph.negation(node);
  }
  std::vector<NodeId> conditions(std::size_t most) {
    std::vector<NodeId> result(1 + random_() % most);
    for (NodeId& each : result) each = condition();
    return result;
  }

  /// Calls `visit` with every assignment of the choices.
  void each_assignment(const std::function<void(Assignment&)>& visit) const {
    std::vector<std::int64_t> values;
    for (const Distribution& domain : domains) values.push_back(domain.lo);
    while (true) {
      Assignment assignment(graph, [&](std::size_t variable) { return Scalar::of(values[variable]); });
      visit(assignment);
      std::size_t at = 0;
      while (at < values.size() && (values[at] += domains[at].step) > domains[at].hi) {
        values[at] = domains[at].lo;
        ++at;
      }
      if (at == values.size()) return;
    }
  }

  Graph graph;
  AddressTable addresses;
  std::vector<Distribution> domains;

 private:
  std::vector<NodeId>& nodes(Type type) { return type == Type::kBool ? bools_ : ints_; }

  std::mt19937_64 random_;
  bool total_;
  std::vector<NodeId> ints_, bools_;
};

const std::vector<Distribution> kFew = {{-2, 2, 1, {}}, {0, 1, 1, {}}, {3, 9, 3, {}}, {-4, -1, 1, {}}};

using Clauses = std::vector<std::vector<NodeId>>;

/// Whether it holds, fails, or depends on an operation without meaning, whose value is anyone's guess.
enum class Truth { kHolds, kFails, kOpen };

Truth truth(Assignment& assignment, NodeId condition) {
  const auto value = assignment.value(condition);
  if (!value) return Truth::kOpen;
  return value->i != 0 ? Truth::kHolds : Truth::kFails;
}

Truth truth(Assignment& assignment, const Clauses& clauses) {
  Truth all = Truth::kHolds;
  for (const auto& clause : clauses) {
    Truth any = Truth::kFails;
    for (const NodeId condition : clause) {
      const Truth one = truth(assignment, condition);
      if (one == Truth::kHolds || (one == Truth::kOpen && any == Truth::kFails)) any = one;
    }
    if (any == Truth::kFails) return any;
    if (any == Truth::kOpen) all = any;
  }
  return all;
}

bool any_assignment(const Thicket& thicket, const Clauses& clauses, Truth wanted) {
  bool found = false;
  thicket.each_assignment([&](Assignment& each) { found = found || truth(each, clauses) == wanted; });
  return found;
}

Clauses with(Clauses clauses, const std::vector<NodeId>& units) {
  for (const NodeId unit : units) clauses.push_back({unit});
  return clauses;
}

std::unique_ptr<Solver> make_solver(const Graph& graph, std::uint64_t seed, bool takes_suggestions) {
  if (takes_suggestions) return make_nearby_then_cadical(graph, {seed, false});
  return make_cadical_solver(graph, seed);
}

void check_model(const Thicket& thicket, Solver& solver, const Clauses& clauses) {
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < thicket.graph.variables().size(); ++i) {
    const Distribution& domain = thicket.graph.variables()[i].domain;
    values.push_back(solver.value(i));
    REQUIRE((domain.lo <= values[i] && values[i] <= domain.hi && (values[i] - domain.lo) % domain.step == 0));
  }
  Assignment model(thicket.graph, [&](std::size_t variable) { return Scalar::of(values[variable]); });
  REQUIRE(truth(model, clauses) != Truth::kFails);
}

TEST_CASE(
    "cadical: checks between added clauses and assumptions of both signs agree with trying all values") {
  const StopSignal never;
  std::size_t satisfiable = 0, unsatisfiable = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const bool diverse = seed % 2 == 1;  // then models are found without CaDiCaL, too
    Thicket thicket(seed, false, kFew);
    const auto solver = make_solver(thicket.graph, seed, diverse);
    std::mt19937_64 random(seed);
    Clauses added;
    for (int round = 0; round < 12; ++round) {
      for (int i = 0; i < 15; ++i) thicket.grow();
      for (std::size_t i = 0; diverse && i < thicket.graph.variables().size(); ++i) {
        const Distribution& domain = thicket.graph.variables()[i].domain;
        const std::int64_t steps = (domain.hi - domain.lo) / domain.step + 1;
        solver->suggest(i, domain.lo + domain.step * static_cast<std::int64_t>(
                                                         random() % static_cast<std::uint64_t>(steps)));
      }
      if (round % 3 == 2) {
        added.push_back(thicket.conditions(4));
        solver->add_clause(added.back());
      }
      const std::vector<NodeId> assumed = thicket.conditions(4);
      const Clauses all = with(added, assumed);
      CAPTURE(seed);
      CAPTURE(round);
      if (solver->check(assumed, never) == Verdict::kSatisfiable) {
        ++satisfiable;
        check_model(thicket, *solver, all);
      } else {
        ++unsatisfiable;
        REQUIRE(!any_assignment(thicket, all, Truth::kHolds));
        const std::vector<NodeId> core = solver->core();
        for (const NodeId each : core)
          REQUIRE(std::find(assumed.begin(), assumed.end(), each) != assumed.end());
        REQUIRE(!any_assignment(thicket, with(added, core), Truth::kHolds));
      }
    }
  }
  CHECK(satisfiable > 600);
  CHECK(unsatisfiable > 600);
}

TEST_CASE("enumerator: goes through all assignments that fulfil random conditions, each once") {
  const StopSignal never;
  std::size_t models = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    Thicket thicket(seed, true, kFew);
    for (int i = 0; i < 120; ++i) thicket.grow();
    const std::vector<NodeId> conditions = thicket.conditions(3);
    std::set<std::vector<std::int64_t>> expected, found;
    thicket.each_assignment([&](Assignment& each) {
      if (truth(each, with({}, conditions)) != Truth::kHolds) return;
      std::vector<std::int64_t> values;
      for (std::size_t i = 0; i < thicket.domains.size(); ++i)
        values.push_back(each.value(thicket.graph.variable_node(i))->i);
      expected.insert(values);
    });
    const std::vector<std::size_t> choices = {0, 1, 2, 3};
    Enumerator enumerator(thicket.graph, conditions, choices);
    while (enumerator.next(never) == Enumerator::Outcome::kFound) {
      std::vector<std::int64_t> values;
      for (const std::size_t choice : choices) values.push_back(enumerator.value(choice));
      REQUIRE(found.insert(values).second);
    }
    CHECK(enumerator.next(never) == Enumerator::Outcome::kNone);
    CHECK(found == expected);
    models += found.size();
  }
  CHECK(models > 1000);
}

TEST_CASE("assignment: once choices have other values, each node is what a new evaluation says") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    Thicket thicket(seed, true, kFew);
    std::mt19937_64 random(seed);
    std::vector<std::int64_t> values(thicket.graph.variables().size());
    const auto draw = [&](std::size_t variable) {
      const Distribution& domain = thicket.graph.variables()[variable].domain;
      values[variable] = domain.value(random() % domain.size());
    };
    for (std::size_t variable = 0; variable < values.size(); ++variable) draw(variable);
    const auto value_of = [&](std::size_t variable) { return Scalar::of(values[variable]); };
    Assignment kept(thicket.graph, value_of);
    for (int round = 0; round < 15; ++round) {
      for (int i = 0; i < 10; ++i) thicket.grow();
      draw(random() % values.size());
      kept.take_changes();
      Assignment fresh(thicket.graph, value_of);
      for (std::uint32_t at = 0; at < thicket.graph.size(); ++at) {
        const auto expected = fresh.value({at}), found = kept.value({at});
        REQUIRE(found.has_value() == expected.has_value());
        if (expected) REQUIRE(found->i == expected->i);
      }
    }
  }
}

TEST_CASE("cadical: agrees with Z3 on random graphs") {
  const StopSignal never;
  std::size_t satisfiable = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Thicket thicket(seed, true,
                    {{-100, 100, 1, {}}, {0, 255, 1, {}}, {1, 64, 1, {}}, {-7, 90, 7, {}}, {0, 1, 1, {}}});
    for (int i = 0; i < 150; ++i) thicket.grow();
    const auto cadical = make_cadical_solver(thicket.graph);
    const auto z3 = make_z3_solver(thicket.graph, thicket.addresses, {});
    for (int round = 0; round < 10; ++round) {
      const std::vector<NodeId> clause = thicket.conditions(3);
      const std::vector<NodeId> assumed = thicket.conditions(2);
      cadical->add_clause(clause);
      z3->add_clause(clause);
      const Verdict verdict = cadical->check(assumed, never);
      CAPTURE(seed);
      CAPTURE(round);
      satisfiable += verdict == Verdict::kSatisfiable ? 1 : 0;
      REQUIRE(verdict == z3->check(assumed, never));
    }
  }
  CHECK(satisfiable > 100);
}

/// A graph of ints to divide.
struct Quotients {
  Quotients(const Distribution& a, const Distribution& b)
      : x(graph.choice({addresses.site(addresses.root(), "x"), a})),
        y(graph.choice({addresses.site(addresses.root(), "y"), b})) {}
  NodeId is(NodeId node, std::int64_t value) {
    return graph.apply(Op::kEqInt, {node, graph.constant(value)});
  }

  Graph graph;
  AddressTable addresses;
  NodeId x, y;
};

TEST_CASE("cadical: a division by zero that does not matter rules nothing out") {
  const StopSignal never;
  for (const Distribution& a : {Distribution{0, 9, 1, {}}, {-9, 9, 1, {}}, {-9, -1, 1, {}}}) {
    for (const Distribution& b : {Distribution{0, 3, 1, {}}, {-2, 2, 1, {}}, {-4, 0, 1, {}}}) {
      Quotients q(a, b);
      const auto solver = make_cadical_solver(q.graph);
      const NodeId quotient = q.graph.apply(Op::kDiv, {q.x, q.y});
      const NodeId rest = q.graph.apply(Op::kMod, {q.x, q.y});
      const NodeId sum = q.graph.apply(Op::kAdd, {q.graph.apply(Op::kMul, {quotient, q.y}), rest});
      const NodeId right[] = {q.is(q.y, 0), q.graph.apply(Op::kEqInt, {sum, q.x})};
      solver->add_clause(right);
      for (std::int64_t x = a.lo; x <= a.hi; ++x) {
        for (std::int64_t y = b.lo; y <= b.hi; ++y) {
          const NodeId here[] = {q.is(q.x, x), q.is(q.y, y)};
          REQUIRE(solver->check(here, never) == Verdict::kSatisfiable);
          REQUIRE((solver->value(0) == x && solver->value(1) == y));
        }
      }
    }
  }
}

TEST_CASE("cadical: with each pair of values excluded once found, every pair is found once") {
  const StopSignal never;
  const std::vector<Distribution> domains = {
      {0, 1, 1, {}}, {-3, 4, 1, {}}, {-9, -2, 1, {}}, {5, 6, 1, {}}, {-5, 16, 7, {}}};
  for (const Distribution& a : domains) {
    for (const Distribution& b : domains) {
      Quotients q(a, b);
      const auto solver = make_cadical_solver(q.graph);
      std::size_t found = 0;
      for (; solver->check({}, never) == Verdict::kSatisfiable; ++found) {
        const NodeId differs[] = {q.graph.negation(q.is(q.x, solver->value(0))),
                                  q.graph.negation(q.is(q.y, solver->value(1)))};
        solver->add_clause(differs);
      }
      const auto size = [](const Distribution& domain) { return (domain.hi - domain.lo) / domain.step + 1; };
      REQUIRE(found == static_cast<std::size_t>(size(a) * size(b)));
    }
  }
}

TEST_CASE("bits: operations on numbers of literals, at every width up to 5") {
  for (std::size_t width = 1; width <= 5; ++width) {
    const std::int64_t count = std::int64_t{1} << width;
    Circuit circuit;
    const auto value = [](const Bits& bits) {
      std::int64_t sum = 0;
      for (std::size_t i = 0; i < bits.size(); ++i) {
        REQUIRE(is_constant(bits[i]));
        if (bits[i] == kTrueLiteral) sum += std::int64_t{1} << i;
      }
      return sum;
    };
    for (std::int64_t x = 0; x < count; ++x) {
      for (std::int64_t y = 0; y < count; ++y) {
        const Bits a = constant_bits(x, width), b = constant_bits(y, width);
        REQUIRE(value(add(circuit, a, b)) == (x + y) % count);
        REQUIRE(value(subtract(circuit, a, b)) == (x - y + count) % count);
        REQUIRE(value(multiply(circuit, a, b, false)) == x * y % count);
        REQUIRE(value(multiply(circuit, a, b, true)) == x * y % count);
        REQUIRE(value(multiply(circuit, a, y)) == x * y % count);
        REQUIRE(value(multiply(circuit, a, -y)) == (count - x * y % count) % count);
        REQUIRE(equal(circuit, a, b) == constant_literal(x == y));
        REQUIRE(less(circuit, a, b, false) == constant_literal(x < y));
        REQUIRE(less(circuit, a, b, true) == constant_literal(x <= y));
        if (y == 0) continue;
        const Division division = divide(circuit, a, b);
        REQUIRE((value(division.quotient) == x / y && value(division.remainder) == x % y));
      }
    }
  }
}

/// Keeps the clauses.
struct Recorder : ClauseSink {
  void clause(std::span<const int> literals) override {
    clauses.emplace_back(literals.begin(), literals.end());
    std::sort(clauses.back().begin(), clauses.back().end());
  }
  std::vector<std::vector<int>> take() { return std::exchange(clauses, {}); }
  std::vector<std::vector<int>> clauses;
};

TEST_CASE("cnf: gates with one use need no variable, and of others only the direction in use is written") {
  Circuit circuit;
  Recorder recorder;
  Cnf cnf(circuit, recorder);
  std::array<Literal, 6> x;
  for (Literal& each : x) {
    each = circuit.input();
    cnf.variable(each);  // 1 to 6
  }
  const auto require = [&](Literal literal) {
    cnf.add_clause({&literal, 1});
    auto clauses = recorder.take();
    std::sort(clauses.begin(), clauses.end());
    return clauses;
  };
  using Expected = std::vector<std::vector<int>>;
  CHECK(require(circuit.disjunction(circuit.disjunction(x[0], !x[1]), x[2])) == Expected{{-2, 1, 3}});
  CHECK(require(circuit.conjunction(circuit.conjunction(x[0], !x[1]), x[3])) == Expected{{-2}, {1}, {4}});
  CHECK(require(circuit.disjunction(x[0], circuit.conjunction(x[2], x[4]))) == Expected{{1, 3}, {1, 5}});
  CHECK(require(circuit.exclusive_or(x[4], x[5])) == Expected{{-6, -5}, {5, 6}});
  CHECK(require(kTrueLiteral).empty());
  CHECK(require(kFalseLiteral) == Expected{{}});

  const Literal shared = circuit.majority(x[1], x[3], x[5]);
  CHECK(cnf.assumable(shared) == 7);
  CHECK(recorder.take().size() == 3);
  CHECK(cnf.assumable(shared) == 7);
  CHECK(recorder.take().empty());
  CHECK(cnf.assumable(!shared) == -7);
  CHECK(recorder.take().size() == 3);
}

TEST_CASE("circuit: equal gates are one, whatever the signs and the order of their operands") {
  Circuit circuit;
  const Literal a = circuit.input(), b = circuit.input(), c = circuit.input();
  CHECK(circuit.conjunction(a, b) == circuit.conjunction(b, a));
  CHECK(circuit.exclusive_or(!a, b) == circuit.exclusive_or(b, !a));
  CHECK(circuit.exclusive_or(!a, b) == !circuit.exclusive_or(b, a));
  CHECK(circuit.mux(!a, b, c) == circuit.mux(a, c, b));
  CHECK(circuit.mux(a, !b, !c) == !circuit.mux(a, b, c));
  CHECK(circuit.parity(a, b, c) == !circuit.parity(c, !a, b));
  CHECK(circuit.majority(!a, !b, !c) == !circuit.majority(c, a, b));
  CHECK(circuit.majority(a, b, !a) == b);
  CHECK(circuit.parity(a, kTrueLiteral, b) == circuit.equivalence(a, b));
}

TEST_CASE("cadical: suggestions are followed where nothing is against them, also for choices met later") {
  const StopSignal never;
  Quotients q({-20, 20, 1, {}}, {0, 60, 4, {}});
  const auto solver = make_nearby_then_cadical(q.graph, {});
  for (const std::int64_t value : {-20, -7, 0, 13, 20}) {
    CHECK(solver->suggest(0, value));
    CHECK(solver->suggest(1, 20 + 2 * value));
    const NodeId somewhere[] = {q.graph.apply(Op::kLeInt, {q.x, q.graph.constant(std::int64_t{19})}),
                                q.graph.apply(Op::kLeInt, {q.x, q.y})};
    if (value >= 0) solver->add_clause(somewhere);
    REQUIRE(solver->check({}, never) == Verdict::kSatisfiable);
    if (value < 0) continue;  // no condition has met the choices yet
    CHECK(solver->value(0) == value);
    if (value % 2 == 0) CHECK(solver->value(1) == 20 + 2 * value);
  }
}

TEST_CASE("cadical: a choice that no condition depends on takes its suggested value, or one of its domain") {
  const StopSignal never;
  Quotients q({5, 9, 1, {}}, {3, 7, 1, {}});
  const auto solver = make_nearby_then_cadical(q.graph, {});
  solver->suggest(1, 6);
  REQUIRE(solver->check({}, never) == Verdict::kSatisfiable);
  CHECK(solver->value(0) == 5);
  CHECK(solver->value(1) == 6);
}

/// More pigeons than holes: hard, and satisfiable as soon as the last pigeon need not be there.
struct Pigeons {
  explicit Pigeons(std::int64_t holes) {
    for (std::int64_t i = 0; i <= holes; ++i) {
      places.push_back(
          graph.choice({addresses.site(addresses.root(), std::to_string(i)), {1, holes, 1, {}}}));
    }
    there = graph.choice({addresses.site(addresses.root(), "there"), {0, 1, 1, {}}});
  }
  NodeId last_is_there() { return graph.apply(Op::kEqInt, {there, graph.constant(std::int64_t{1})}); }
  void fill(Solver& solver) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const NodeId same = graph.apply(Op::kEqInt, {places[i], places[j]});
        const NodeId clause[] = {graph.negation(same), graph.negation(last_is_there())};
        solver.add_clause({clause, i + 1 == places.size() ? 2U : 1U});
      }
    }
  }

  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> places;
  NodeId there;
};

TEST_CASE("cadical: a check that was stopped can be followed by others") {
  Pigeons pigeons(12);
  const auto solver = make_cadical_solver(pigeons.graph);
  pigeons.fill(*solver);
  const NodeId all[] = {pigeons.last_is_there()};
  StopSignal soon;
  const auto start = StopSignal::Clock::now();
  soon.set_deadline(start + std::chrono::milliseconds(30));
  REQUIRE(solver->check(all, soon) == Verdict::kStopped);
  CHECK(StopSignal::Clock::now() - start < std::chrono::seconds(5));
  const StopSignal never;
  REQUIRE(solver->check({}, never) == Verdict::kSatisfiable);
  CHECK(solver->value(13) == 0);
  const NodeId none = pigeons.graph.negation(all[0]);
  solver->add_clause({&none, 1});
  REQUIRE(solver->check(all, never) == Verdict::kUnsatisfiable);
  CHECK(solver->core() == std::vector<NodeId>{all[0]});
}

TEST_CASE("cadical: the same calls with the same seed give the same models") {
  const StopSignal never;
  const auto models = [&](std::uint64_t seed) {
    Pigeons pigeons(9);
    const auto solver = make_nearby_then_cadical(pigeons.graph, {seed, false});
    pigeons.fill(*solver);
    std::vector<std::int64_t> values;
    for (std::int64_t round = 0; round < 5; ++round) {
      for (std::size_t i = 0; i < 9; ++i) {
        solver->suggest(i, 1 + (round + static_cast<std::int64_t>(i * seed)) % 9);
      }
      REQUIRE(solver->check({}, never) == Verdict::kSatisfiable);
      for (std::size_t i = 0; i < 9; ++i) values.push_back(solver->value(i));
    }
    return values;
  };
  CHECK(models(1) == models(1));
  CHECK(models(1) != models(2));
}

TEST_CASE("cadical: graphs may be deeper than the machine's stack") {
  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> flips;
  for (int i = 0; i < 50; ++i) {
    const NodeId choice = graph.choice({addresses.site(addresses.root(), std::to_string(i)), {0, 1, 1, {}}});
    flips.push_back(graph.apply(Op::kEqInt, {choice, graph.constant(std::int64_t{1})}));
  }
  NodeId deep = flips[0];
  for (std::size_t i = 1; i < 100'000; ++i) {
    const NodeId flip = flips[i % flips.size()];
    deep = i % 3 == 0 ? graph.apply(Op::kIteBool, {flip, graph.negation(deep), flips[(7 * i) % flips.size()]})
           : i % 3 == 1 ? graph.conjunction(deep, graph.negation(flip))
                        : graph.disjunction(deep, flip);
  }
  const StopSignal never;
  const auto solver = make_cadical_solver(graph);
  solver->add_clause({&deep, 1});
  REQUIRE(solver->check({}, never) == Verdict::kSatisfiable);
  Assignment model(graph, [&](std::size_t variable) { return Scalar::of(solver->value(variable)); });
  CHECK(model.holds(deep));
}

TEST_CASE("wide choices: those of which bits are read as often as orders have no order") {
  Graph graph;
  AddressTable addresses;
  std::vector<NodeId> x;
  for (int i = 0; i < 6; ++i) {
    const AddressId address = addresses.site(addresses.root(), std::to_string(i));
    x.push_back(graph.choice({address, Distribution::range(0, i == 5 ? 200 : 300)}));
  }
  const auto apply = [&](Op op, NodeId a, NodeId b) { return graph.apply(op, {a, b}); };
  const auto differ = [&](NodeId a, NodeId b) { return graph.negation(apply(Op::kEqInt, a, b)); };
  const std::vector<NodeId> conditions = {
      apply(Op::kEqInt, x[0], apply(Op::kAdd, x[1], x[2])),  // a sum too wide to have an order
      apply(Op::kLtInt, x[1], x[2]),
      apply(Op::kLeInt, x[0], apply(Op::kAdd, x[5], x[3])),
      differ(x[3], x[4]),
      differ(x[3], x[2]),
  };
  Circuit circuit;
  struct : ClauseSink {
    void clause(std::span<const int>) override {}
  } sink;
  Cnf cnf(circuit, sink);
  BitBlaster blaster(graph, circuit, cnf);
  for (const NodeId condition : conditions) blaster.condition(condition);
  for (const std::size_t in_bits : {0, 1}) CHECK(blaster.choices().order(in_bits) == nullptr);
  for (const std::size_t in_order : {2, 3, 4, 5}) CHECK(blaster.choices().order(in_order) != nullptr);
}

TEST_CASE("wide choices: solvers and the enumerator agree on how many values sums and orders of them leave") {
  Graph graph;
  AddressTable addresses;
  const auto choice = [&](const char* name, std::int64_t most) {
    return graph.choice({addresses.site(addresses.root(), name), Distribution::range(0, most)});
  };
  const NodeId x = choice("x", 300), y = choice("y", 300), s = choice("s", 19);
  const std::vector<NodeId> conditions = {graph.apply(Op::kEqInt, {s, graph.apply(Op::kAdd, {x, y})}),
                                          graph.apply(Op::kLtInt, {x, y})};
  std::size_t expected = 0;
  for (std::int64_t sum = 0; sum <= 19; ++sum) expected += static_cast<std::size_t>((sum + 1) / 2);
  const StopSignal never;
  const std::size_t variables[] = {0, 1, 2};
  Enumerator enumerator(graph, conditions, variables);
  std::set<std::array<std::int64_t, 3>> found;
  while (enumerator.next(never) == Enumerator::Outcome::kFound)
    found.insert({enumerator.value(0), enumerator.value(1), enumerator.value(2)});
  CHECK(found.size() == expected);
  for (const auto& [a, b, sum] : found) CHECK((a + b == sum && a < b));
  for (const auto& solver : {make_cadical_solver(graph), make_z3_solver(graph, addresses, {})}) {
    for (const NodeId condition : conditions) solver->add_clause({&condition, 1});
    for (std::int64_t value : {0, 1, 9, 10}) {
      const NodeId is = graph.apply(Op::kEqInt, {x, graph.constant(value)});
      const Verdict verdict = solver->check({&is, 1}, never);
      CHECK((verdict == Verdict::kSatisfiable) == (value < 10));
    }
  }
}

}  // namespace
}  // namespace solitaire
