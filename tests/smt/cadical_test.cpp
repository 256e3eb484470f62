// CaDiCaL that begins anew, against brute force: it keeps the clauses, and takes further ones.
#include "smt/sat/cadical.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <vector>

#include "tests/smt/random_clauses.h"

namespace solitaire {
namespace {

constexpr int kCadicalVariables = 10;

bool fulfilled(const Clause& clause, unsigned model) {
  return std::ranges::any_of(clause, [&](int literal) {
    return ((model >> (std::abs(literal) - 1)) & 1U) == (literal > 0 ? 1U : 0U);
  });
}

bool has_model(const std::vector<Clause>& clauses) {
  for (unsigned model = 0; model < 1U << kCadicalVariables; ++model) {
    if (std::ranges::all_of(clauses, [&](const Clause& clause) { return fulfilled(clause, model); }))
      return true;
  }
  return false;
}

unsigned model_of(const Cadical& cadical) {
  unsigned model = 0;
  for (int variable = 1; variable <= kCadicalVariables; ++variable) {
    if (cadical.holds(variable)) model |= 1U << (variable - 1);
  }
  return model;
}

TEST_CASE("cadical: a new beginning keeps the clauses, with models and without") {
  std::mt19937_64 random(5);
  int with = 0, without = 0;
  for (int i = 0; i < 60; ++i) {
    Cadical cadical(Cadical::Use::kDiversity, 1);
    std::vector<Clause> clauses;
    for (int step = 0; step < 5; ++step) {
      for (int j = 0; j < 12; ++j) {
        clauses.push_back(random_clause(random, kCadicalVariables, 3, 1));
        cadical.clause(clauses.back());
      }
      if (step % 2 == 1) cadical.start_anew(random());
      if (step == 2) cadical.use_for(Cadical::Use::kRefutation);
      const Verdict verdict = cadical.solve({}, StopSignal());
      const bool expected = has_model(clauses);
      CHECK((verdict == Verdict::kSatisfiable) == expected);
      ++(expected ? with : without);
      if (!expected) break;
      const unsigned model = model_of(cadical);
      CHECK(std::ranges::all_of(clauses, [&](const Clause& clause) { return fulfilled(clause, model); }));
    }
  }
  CHECK(with > 60);
  CHECK(without > 20);
}

}  // namespace
}  // namespace solitaire
