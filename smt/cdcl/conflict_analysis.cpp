#include "smt/cdcl/conflict_analysis.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace solitaire {

void ConflictAnalysis::analyze(const Propagator& propagator) {
  for (const int variable : met_) is_met_[static_cast<std::size_t>(variable)] = 0;
  met_.clear();
  is_met_.resize(propagator.variables());
  collect(propagator);
  shorten(propagator);
  decisions_ = 0;
  if (clause_.size() < 2) return;
  const auto last = std::max_element(clause_.begin() + 1, clause_.end(), [&](int a, int b) {
    return propagator.level(std::abs(a)) < propagator.level(std::abs(b));
  });
  std::swap(clause_[1], *last);
  decisions_ = propagator.level(std::abs(clause_[1]));
}

/// Replaces literals that were assigned since the last decision by their reasons, the latest first, until
/// only one of them is left.
void ConflictAnalysis::collect(const Propagator& propagator) {
  clause_.assign(1, 0);
  met_at_last_ = 0;
  for (const int literal : propagator.conflict()) meet(propagator, literal);
  const std::span<const int> trail = propagator.trail();
  for (std::size_t i = trail.size();;) {
    do --i;
    while (!is_met(std::abs(trail[i])));
    if (--met_at_last_ == 0) {
      clause_[0] = -trail[i];
      return;
    }
    propagator.for_each_reason(trail[i], [&](int literal) { meet(propagator, literal); });
  }
}

void ConflictAnalysis::meet(const Propagator& propagator, int falsified) {
  const int variable = std::abs(falsified);
  const std::size_t level = propagator.level(variable);
  if (level == 0 || is_met(variable)) return;
  is_met_[static_cast<std::size_t>(variable)] = 1;
  met_.push_back(variable);
  if (level == propagator.decisions()) {
    ++met_at_last_;
  } else {
    clause_.push_back(falsified);
  }
}

/// Removes the literals that follow from the other literals of the clause.
void ConflictAnalysis::shorten(const Propagator& propagator) {
  const auto redundant = [&](int literal) { return follows_from_others(propagator, literal); };
  clause_.erase(std::remove_if(clause_.begin() + 1, clause_.end(), redundant), clause_.end());
}

bool ConflictAnalysis::follows_from_others(const Propagator& propagator, int falsified) const {
  bool has_reason = false, follows = true;
  propagator.for_each_reason(-falsified, [&](int literal) {
    has_reason = true;
    const int variable = std::abs(literal);
    follows = follows && (is_met(variable) || propagator.level(variable) == 0);
  });
  return has_reason && follows;
}

}  // namespace solitaire
