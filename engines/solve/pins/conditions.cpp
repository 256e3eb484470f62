#include "engines/solve/pins/conditions.h"

#include <algorithm>
#include <map>

namespace solitaire {
namespace {

/// Returns true if an end is the same in all executions. Its condition compares it with the choice.
bool is_fixed(const Graph& graph, NodeId condition) {
  const auto operands = graph.node(condition).args();
  return std::any_of(operands.begin(), operands.end(),
                     [&](NodeId operand) { return graph.node(operand).is_constant(); });
}

Condition condition_of(Graph& graph, const SymbolicPass& pass, const PinnedChoice& pinned) {
  const TraceChoice& choice = *pinned.choice;
  Condition condition{{}, choice.address, choice.span, choice.span, "", "", pinned.pin, choice.domain};
  condition.pinned = pinned_text(pass, pinned);
  const bool is_impossible = !pinned.pin->forbidden && pinned.holds == graph.negation(choice.guard);
  if (is_impossible) condition.possible = possible_text(pass, choice);
  return condition;
}

}  // namespace

bool is_end(ConstraintKind requirement) {
  return requirement == ConstraintKind::kLowEnd || requirement == ConstraintKind::kHighEnd ||
         requirement == ConstraintKind::kStep;
}

std::vector<TracedCondition> conditions_of(Graph& graph, const SymbolicPass& pass, Pins& pins) {
  const Trace& trace = pass.trace;
  std::map<Condition, TracedCondition> conditions;
  // The same condition is met on several paths where exclusive branches share an address.
  const auto add = [&](Condition condition, NodeId guard, NodeId holds) {
    TracedCondition& traced = conditions.try_emplace(condition).first->second;
    traced.condition = std::move(condition);
    traced.holds = graph.conjunction(traced.holds, holds);
    traced.met = graph.disjunction(traced.met, guard);
  };
  std::map<AddressId, Distribution> domains;
  for (const TraceChoice& choice : trace.choices) domains.emplace(choice.address, choice.domain);

  for (const Term& each : trace.hard_terms) {
    Condition condition{each.requirement, each.address, each.span, each.whole,
                        each.message,     each.turn,    nullptr,   {}};
    if (is_end(each.requirement) && is_fixed(graph, each.node)) condition.domain = domains[each.address];
    condition.unlike = each.node == kFalse && pass.unlike.contains(each.span);
    add(std::move(condition), each.guard, graph.implication(each.guard, each.node));
  }
  for (const PinnedChoice& pinned : pinned_choices(graph, pass, pins))
    add(condition_of(graph, pass, pinned), pinned.choice->guard, pinned.holds);
  std::vector<TracedCondition> list;
  for (auto& [key, traced] : conditions) list.push_back(std::move(traced));
  return list;
}

}  // namespace solitaire
