// What is learned from conflicts, on random clauses against all assignments; and the queue of variables that
// had a part in them against a list.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <vector>

#include "smt/cdcl/conflict_analysis.h"
#include "smt/cdcl/propagator.h"
#include "smt/cdcl/vmtf_queue.h"
#include "tests/smt/random_clauses.h"

namespace solitaire {
namespace {

constexpr int kVariables = 11;

/// The assignments, a bit for each variable, that fulfil the clause.
bool fulfils(std::uint32_t assignment, const Clause& clause) {
  return std::ranges::any_of(clause, [&](int literal) {
    return ((assignment >> std::abs(literal)) & 1) == (literal > 0 ? 1U : 0U);
  });
}

std::vector<std::uint32_t> models(const std::vector<Clause>& clauses) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t assignment = 0; assignment < 2U << kVariables; assignment += 2) {
    if (std::ranges::all_of(clauses, [&](const Clause& clause) { return fulfils(assignment, clause); }))
      found.push_back(assignment);
  }
  return found;
}

/// A clause of the formula, or one that follows from it, says so.
void check_reasons(const Propagator& propagator, const std::vector<std::uint32_t>& all) {
  for (const int literal : propagator.trail()) {
    Clause reason{literal};
    propagator.for_each_reason(literal, [&](int other) {
      CHECK(propagator.value(other) < 0);
      CHECK(propagator.level(std::abs(other)) <= propagator.level(std::abs(literal)));
      reason.push_back(other);
    });
    if (reason.size() == 1) continue;
    CHECK(std::ranges::all_of(all, [&](std::uint32_t model) { return fulfils(model, reason); }));
  }
}

struct Counts {
  std::size_t learned = 0, satisfiable = 0, unsatisfiable = 0;
};

/// Decides at random and learns, until all variables are assigned or it is known that nothing fulfils the
/// conditions. `all` are the assignments that do.
void check_learning(Propagator& propagator, const std::vector<std::uint32_t>& all, std::mt19937_64& random,
                    Counts& counts) {
  ConflictAnalysis analysis;
  bool found = false;
  while (true) {
    if (propagator.propagate()) {
      check_reasons(propagator, all);
      std::vector<int> open;
      for (int variable = 1; variable <= kVariables; ++variable) {
        if (propagator.is_open(variable)) open.push_back(variable);
      }
      found = open.empty();
      if (found) break;
      decide_randomly(propagator, open, random);
      continue;
    }
    if (propagator.decisions() == 0) break;
    for (const int literal : propagator.conflict()) CHECK(propagator.value(literal) < 0);
    analysis.analyze(propagator);
    const Clause clause(analysis.clause().begin(), analysis.clause().end());
    for (const int literal : clause) CHECK(propagator.value(literal) < 0);
    REQUIRE(std::ranges::all_of(all, [&](std::uint32_t model) { return fulfils(model, clause); }));
    REQUIRE(analysis.decisions() < propagator.decisions());
    while (propagator.decisions() > analysis.decisions()) propagator.undo();
    CHECK(propagator.is_open(clause[0]));
    for (std::size_t i = 1; i < clause.size(); ++i) {
      CHECK(propagator.value(clause[i]) < 0);
      CHECK(propagator.level(std::abs(clause[i])) <= propagator.level(std::abs(clause[1])));
    }
    propagator.learn(clause);
    CHECK(propagator.value(clause[0]) > 0);
    ++counts.learned;
    if (random() % 16 != 0) continue;
    while (propagator.decisions() > 0) propagator.undo();
    const std::size_t before = propagator.learned();
    if (!propagator.propagate()) continue;
    propagator.forget_half();
    CHECK(propagator.learned() == before - before / 2);
  }
  CHECK(found == !all.empty());
  ++(found ? counts.satisfiable : counts.unsatisfiable);
  if (!found) return;
  std::uint32_t model = 0;
  for (int variable = 1; variable <= kVariables; ++variable)
    model |= propagator.value(variable) > 0 ? 1U << variable : 0U;
  CHECK(std::ranges::find(all, model) != all.end());
}

bool holds(std::uint32_t assignment, int literal) { return fulfils(assignment, {literal}); }

/// Which of its values an int in order encoding has.
std::size_t position(std::uint32_t assignment, const std::vector<int>& chain) {
  return static_cast<std::size_t>(
      std::ranges::count_if(chain, [&](int literal) { return holds(assignment, literal); }));
}

bool fulfils(std::uint32_t assignment, const OrderDifference& difference) {
  if (difference.guard != 0 && !holds(assignment, difference.guard)) return true;
  const std::size_t a = position(assignment, *difference.a) - difference.first;
  return a >= difference.count || a != position(assignment, *difference.b) - difference.base;
}

bool fulfils(std::uint32_t assignment, const LinearImplication& implication) {
  if (!holds(assignment, implication.guard)) return true;
  std::int64_t sum = 0;
  for (const auto& [chain, weights] : implication.terms) sum += weights[position(assignment, *chain)];
  return sum >= implication.least;
}

int random_guard(std::mt19937_64& random) {
  return (9 + static_cast<int>(random() % 3)) * (random() % 2 == 0 ? 1 : -1);
}

OrderDifference random_difference(std::mt19937_64& random, const std::vector<int>& a,
                                  const std::vector<int>& b) {
  OrderDifference made{&a, &b, random() % 3 == 0 ? random_guard(random) : 0};
  made.first = static_cast<std::uint32_t>(random() % a.size());
  made.base = static_cast<std::uint32_t>(random() % b.size());
  made.count = 1 + static_cast<std::uint32_t>(random() %
                                              std::min(a.size() + 1 - made.first, b.size() + 1 - made.base));
  return made;
}

LinearImplication random_sum(std::mt19937_64& random, const std::vector<std::vector<int>>& chains) {
  LinearImplication made{random_guard(random), {}, 0};
  std::int64_t most = 0;
  for (const std::vector<int>& chain : chains) {
    std::vector<std::int64_t> weights{static_cast<std::int64_t>(random() % 5)};
    const int direction = random() % 2 == 0 ? 1 : -1;
    while (weights.size() <= chain.size())
      weights.push_back(weights.back() + direction * static_cast<std::int64_t>(random() % 4));
    most += std::max(weights.front(), weights.back());
    made.terms.push_back({&chain, std::move(weights)});
  }
  made.least = most - static_cast<std::int64_t>(random() % 8);
  return made;
}

}  // namespace

TEST_CASE("conflict analysis: learns clauses that follow, assign and decide whether there is a model") {
  Counts counts;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    Propagator propagator;
    propagator.reserve(kVariables);
    std::vector<Clause> clauses;
    for (std::size_t i = 35 + random() % 30; i > 0; --i) {
      clauses.push_back(random_clause(random, kVariables, 2, 4));
      propagator.clause(clauses.back());
    }
    check_learning(propagator, models(clauses), random, counts);
  }
  CHECK(counts.learned > 300);
  CHECK(counts.satisfiable > 50);
  CHECK(counts.unsatisfiable > 50);
}

TEST_CASE("conflict analysis: learns from conditions on ints that are no clauses") {
  Counts counts;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    Propagator propagator;
    propagator.reserve(kVariables);
    const std::vector<std::vector<int>> chains{{1, 2, 3}, {4, 5, 6}, {7, 8}};
    std::vector<Clause> clauses{{-2, 1}, {-3, 2}, {-5, 4}, {-6, 5}, {-8, 7}};
    for (std::size_t i = random() % 35; i > 0; --i)
      clauses.push_back(random_clause(random, kVariables, 2, 4));
    for (const Clause& clause : clauses) propagator.clause(clause);
    std::vector<std::uint32_t> all = models(clauses);
    const auto add = [&](const auto& condition) {
      std::erase_if(all, [&](std::uint32_t model) { return !fulfils(model, condition); });
    };
    for (std::size_t i = random() % 4; i > 0; --i) {
      const std::size_t first = random() % 3;
      const OrderDifference made = random_difference(random, chains[first], chains[(first + 1) % 3]);
      propagator.order_difference(made);
      add(made);
    }
    for (std::size_t i = 1 + random() % 3; i > 0; --i) {
      const LinearImplication made = random_sum(random, chains);
      propagator.linear_implication(made);
      add(made);
    }
    check_learning(propagator, all, random, counts);
  }
  CHECK(counts.learned > 200);
  CHECK(counts.satisfiable > 100);
  CHECK(counts.unsatisfiable > 30);
}

TEST_CASE("conflict queue: the open variable that had a part in a conflict last") {
  std::mt19937_64 random(7);
  VmtfQueue queue;
  std::vector<int> list;  // the last first
  std::vector<bool> open(20, true);
  const auto is_open = [&](int variable) {
    return static_cast<bool>(open[static_cast<std::size_t>(variable)]);
  };
  std::size_t found = 0;
  for (int step = 0; step < 5000; ++step) {
    const int variable = 1 + static_cast<int>(random() % 19);
    switch (random() % 6) {
      case 0: {
        std::vector<int> moved{variable};
        const int other = 1 + static_cast<int>(random() % 19);
        if (other != variable) moved.push_back(other);
        queue.move_to_front(moved);
        std::ranges::sort(moved, {}, [&](int each) { return std::ranges::find(list, each) - list.begin(); });
        const bool both_new =
            std::ranges::none_of(moved, [&](int each) { return std::ranges::count(list, each) > 0; });
        if (both_new && moved.size() == 2) moved = {other, variable};  // in the order of the call
        for (const int each : moved) std::erase(list, each);
        list.insert(list.begin(), moved.begin(), moved.end());
        break;
      }
      case 1:
        if (random() % 40 != 0) break;
        queue.clear();
        list.clear();
        break;
      case 2:
      case 3:
        open[static_cast<std::size_t>(variable)] = true;
        queue.open(variable);
        break;
      default:
        open[static_cast<std::size_t>(variable)] = false;
    }
    const auto first = std::ranges::find_if(list, is_open);
    REQUIRE(queue.first_open(is_open) == (first == list.end() ? 0 : *first));
    found += first == list.end() ? 0 : 1;
  }
  CHECK(found > 1000);
}

}  // namespace solitaire
