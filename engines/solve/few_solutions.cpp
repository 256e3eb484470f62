#include "engines/solve/few_solutions.h"

#include <utility>

#include "base/random.h"
#include "engines/errors.h"
#include "engines/solve/enumeration.h"
#include "engines/solve/executions/auxiliary.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

/// Returns true if the ranges of the choices have no more combinations than that.
bool has_few_combinations(const Trace& trace, std::uint64_t most) {
  std::uint64_t combinations = 1;
  for (const TraceChoice& choice : trace.choices) {
    if (choice.domain.size() > most / combinations) return false;
    combinations *= choice.domain.size();
  }
  return true;
}

/// Returns true if each solution is one of an enumeration, and each of those another one.
bool can_go_through(TracedProgram& traced) {
  const Trace& trace = traced.trace();
  return trace.blockers.empty() && !trace.has_costs() && follow_from_others(traced.graph(), trace);
}

void shuffle(std::vector<Valuation>& all, RandomStream stream) {
  for (std::size_t left = all.size(); left > 1; --left) std::swap(all[left - 1], all[stream.below(left)]);
}

}  // namespace

std::optional<std::vector<Valuation>> few_solutions(TracedProgram& traced, std::size_t most,
                                                    std::uint64_t seed) {
  try {
    traced.explore();
    traced.meet_pass();
  } catch (const Interrupted&) {
    return std::nullopt;
  }
  if (!has_few_combinations(traced.trace(), tuning::kMostCombinations * most) || !can_go_through(traced))
    return std::nullopt;
  Enumeration enumeration(traced.solver(), traced.requirements(true), false);
  std::vector<Valuation> all;
  while (true) {
    const Enumeration::Outcome outcome = enumeration.next(traced.stop());
    if (outcome == Enumeration::Outcome::kNone) break;
    if (outcome != Enumeration::Outcome::kFound || all.size() == most) return std::nullopt;
    Assignment& assignment = enumeration.assignment();
    all.push_back(traced.solver().met(assignment).values);
  }
  shuffle(all, RandomStream(seed, Purpose::kSample, 0));
  return all;
}

}  // namespace solitaire
