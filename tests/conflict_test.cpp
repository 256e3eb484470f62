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
#include "tests/random_clauses.h"

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

}  // namespace

TEST_CASE("conflict analysis: learns clauses that follow, assign and decide whether there is a model") {
  std::size_t learned = 0, satisfiable = 0, unsatisfiable = 0;
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
    const std::vector<std::uint32_t> all = models(clauses);
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
      ++learned;
      if (random() % 16 != 0) continue;
      while (propagator.decisions() > 0) propagator.undo();
      const std::size_t before = propagator.learned();
      if (!propagator.propagate()) continue;
      propagator.forget_half();
      CHECK(propagator.learned() == before - before / 2);
    }
    CHECK(found == !all.empty());
    ++(found ? satisfiable : unsatisfiable);
    if (!found) continue;
    std::uint32_t model = 0;
    for (int variable = 1; variable <= kVariables; ++variable)
      model |= propagator.value(variable) > 0 ? 1U << variable : 0U;
    CHECK(std::ranges::find(all, model) != all.end());
  }
  CHECK(learned > 300);
  CHECK(satisfiable > 50);
  CHECK(unsatisfiable > 50);
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
