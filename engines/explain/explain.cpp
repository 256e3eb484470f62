#include "engines/explain/explain.h"

#include <algorithm>
#include <cstdlib>

#include "engines/solve/pins/wide_choices.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

/// The largest number that a graph knows, or its negative.
std::int64_t largest_constant(const Graph& graph) {
  std::int64_t largest = 0;
  for (std::uint32_t i = 0; i < graph.size(); ++i) {
    const Graph::Node& node = graph.node({i});
    if (node.op == Op::kConstInt) largest = std::max(largest, std::abs(node.interval.lo));
  }
  return largest;
}

/// Says why there is no further conflict when the question whether what is not explained yet can hold
/// together came to this.
Ending ending_after(ConditionSolver::Outcome outcome) {
  if (outcome == ConditionSolver::Outcome::kFound) return Ending::kExhausted;
  return outcome == ConditionSolver::Outcome::kNone ? Ending::kNone : ending_of(outcome);
}

}  // namespace

Explainer::Explainer(const Program& program, ParamValues params, const TracingOptions& options, bool thorough)
    : program_(program),
      params_(std::move(params)),
      options_(options),
      thorough_(thorough),
      pins_(options.pins, addresses_),
      choices_(pins_),
      solver_(program, params_, options, choices_, addresses_, pins_) {}

/// Conflicts are looked for among conditions that are in none so far. The ends of ranges come last, so that
/// two can share one; then they are not independent, and the later one is passed over.
std::optional<Conflict> Explainer::next_conflict() {
  while (std::optional<Conflict> conflict = another_conflict()) {
    const auto is_shown = [this](const Condition& each) { return shown_.count(each) != 0; };
    if (std::any_of(conflict->members.begin(), conflict->members.end(), is_shown)) continue;
    shown_.insert(conflict->members.begin(), conflict->members.end());
    return conflict;
  }
  return std::nullopt;
}

std::optional<Conflict> Explainer::another_conflict() {
  if (ending_ != Ending::kNone) return std::nullopt;
  ending_ = ending_after(find_unexplained());
  if (ending_ != Ending::kNone) return std::nullopt;
  Conditions members = solver_.core();
  const bool minimal = minimize(solver_, members, {});
  explained_.insert(members.begin(), members.end());
  try {
    return complete(members, minimal);
  } catch (const Interrupted&) {
    return Conflict{{members.begin(), members.end()}, false, solver_.over_full(members)};
  }
}

/// Asks whether the conditions that are in no conflict yet can hold together; if not, the solver has a core.
/// Where they are many, all of them are one part at first, and then those of each place: of few parts a core
/// is found much sooner, and most places are left out by then.
Explainer::Outcome Explainer::find_unexplained() {
  const auto among = [this](const auto& wanted, Grain grain) {
    const Outcome outcome = solver_.find(wanted, nullptr, ConditionSolver::Ends::kErrors, grain);
    if (outcome == Outcome::kNone) tell(solver_.core());
    return outcome;
  };
  const auto unexplained = [this](const Condition& each) { return explained_.count(each) == 0; };
  try {
    if (solver_.all().size() < tuning::kManyConditions) return among(unexplained, Grain::kConditions);
  } catch (const Interrupted&) {
    return Outcome::kStopped;
  }
  for (const Grain grain : {Grain::kAll, Grain::kPlaces}) {
    const Outcome outcome = among(unexplained, grain);
    if (outcome != Outcome::kNone) return outcome;
  }
  Conditions members = solver_.core();
  minimize_places(members);
  return among([&](const Condition& each) { return members.count(each) != 0; }, Grain::kConditions);
}

/// Leaves out all conditions of a place at once, for as long as the rest cannot hold together.
void Explainer::minimize_places(Conditions& members) {
  std::vector<Span> places;
  for (const Condition& member : members) {
    if (places.empty() || places.back() != member.span) places.push_back(member.span);
  }
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    Conditions rest = members;
    std::erase_if(rest, [&](const Condition& each) { return each.span == *place; });
    if (rest.size() == members.size()) continue;
    if (solver_.find(rest, Grain::kPlaces) != Outcome::kNone) continue;
    members = solver_.core();
    tell(members);
  }
}

void Explainer::tell(const Conditions& members) const {
  if (told_) told_({{members.begin(), members.end()}, false});
}

/// Leaves members out for as long as the rest cannot hold together; the fixed ones stay. False if some may be
/// left that could be left out.
///
/// A question that takes long is put off: once others are left out, it may be an easy one. Where members are
/// many, a few such questions are enough to end: each place of the text is told once, however many are left.
bool Explainer::minimize(ConditionSolver& solver, Conditions& members, const Conditions& fixed) const {
  Conditions needed = fixed;
  const bool is_bounded = is_many(members);
  solver.limit_effort(tuning::kEffortForMember);
  std::size_t open = leave_out(solver, members, needed, is_bounded ? tuning::kMostOpenMembers : SIZE_MAX);
  solver.limit_effort(0);
  if (open > 0 && !is_bounded) open = leave_out(solver, members, needed, SIZE_MAX);
  return open == 0;
}

/// Asks of each member once whether it can be left out, until so many questions were given up. Returns how
/// many were. Members without which the others can hold are added to those that are needed.
std::size_t Explainer::leave_out(ConditionSolver& solver, Conditions& members, Conditions& needed,
                                 std::size_t most_open) const {
  const Conditions fixed = needed;
  const std::vector<Condition> candidates(members.rbegin(), members.rend());
  std::size_t open = 0;
  for (const Condition& candidate : candidates) {
    if (members.count(candidate) == 0 || needed.count(candidate) != 0) continue;
    Conditions rest = members;
    rest.erase(candidate);
    const Outcome outcome = solver.find(rest);
    if (outcome == Outcome::kNone) {
      members = solver.core();
      members.insert(fixed.begin(), fixed.end());
      tell(members);
    } else if (outcome == Outcome::kFound) {
      needed.insert(candidate);
    } else if (++open >= most_open) {
      return open;
    }
  }
  return open;
}

bool Explainer::is_many(const Conditions& members) const {
  return !thorough_ && members.size() > tuning::kManyConditions;
}

/// Finds the choices on which conditions depend. While choices lie within their ranges, intervals decide many
/// conditions, and then no node tells any more on which choices these depend. So this looks at a trace in
/// which the choices may have any values that the solver's numbers allow.
std::optional<Explainer::Freedom> Explainer::choices_below(const Conditions& members) {
  for (const std::int64_t reach :
       {2 * std::min(largest_constant(solver_.graph()), tuning::kMostReach), tuning::kLeastReach}) {
    WideChoices choices(nullptr, reach, pins_);
    ConditionSolver wide(program_, params_, options_, choices, addresses_, pins_);
    if (wide.inexpressible() > solver_.inexpressible()) continue;
    Conditions conditions = members;
    Freedom freedom{{}, reach};
    for (bool grows = true; grows;) {  // the ends of ranges depend on further choices
      const std::size_t before = freedom.choices.size();
      freedom.choices.merge(wide.choices_below(conditions));
      freedom.choices.merge(solver_.choices_below(conditions));
      for (const TracedCondition& each : wide.all()) {
        if (is_end(each.condition.requirement) && freedom.choices.count(each.condition.address) != 0)
          conditions.insert(each.condition);
      }
      grows = freedom.choices.size() > before;
    }
    return freedom;
  }
  return std::nullopt;
}

/// Completes a conflict by the ends of ranges that take part: its conditions cannot hold together because
/// choices lie within their ranges, so these choices are freed, and the ends become conditions of their own.
Conflict Explainer::complete(Conditions members, bool minimal) {
  Conflict conflict{{members.begin(), members.end()}, false, solver_.over_full(members)};
  const std::optional<Freedom> freedom = choices_below(members);
  if (!freedom) return conflict;
  WideChoices choices(&freedom->choices, freedom->reach, pins_);
  ConditionSolver wide(program_, params_, options_, choices, addresses_, pins_);
  if (is_many(members)) wide.limit_effort(tuning::kEffortForEnds);
  const Outcome outcome = wide.find([&](const Condition& each) {
    return members.count(each) != 0 ||
           (is_end(each.requirement) && freedom->choices.count(each.address) != 0);
  });
  if (outcome != Outcome::kNone) return conflict;
  Conditions with_ends = wide.core();
  with_ends.insert(members.begin(), members.end());
  tell(with_ends);
  conflict.minimal = minimize(wide, with_ends, members) && minimal;
  conflict.members.assign(with_ends.begin(), with_ends.end());
  conflict.room = wide.over_full(with_ends);
  return conflict;
}

}  // namespace solitaire
