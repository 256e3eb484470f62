#pragma once
#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

#include "smt/cdcl/propagator.h"

namespace solitaire {

using Clause = std::vector<int>;

/// Of different variables from 1 to `variables`; as many as `least`, or up to `spread` - 1 more.
inline Clause random_clause(std::mt19937_64& random, int variables, std::size_t least, std::size_t spread) {
  Clause clause;
  const std::size_t size = least + random() % spread;
  while (clause.size() < size) {
    const int variable = 1 + static_cast<int>(random() % static_cast<unsigned>(variables));
    const auto same = [&](int literal) { return std::abs(literal) == variable; };
    if (std::ranges::none_of(clause, same)) clause.push_back(random() % 2 == 0 ? variable : -variable);
  }
  return clause;
}

/// Decides one of the open variables, of which there is at least one; returns the literal.
inline int decide_randomly(Propagator& propagator, const std::vector<int>& open, std::mt19937_64& random) {
  const int variable = open[random() % open.size()];
  const int literal = random() % 2 == 0 ? variable : -variable;
  propagator.decide(literal);
  return literal;
}

}  // namespace solitaire
