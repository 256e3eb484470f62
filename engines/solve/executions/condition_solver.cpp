#include "engines/solve/executions/condition_solver.h"

#include <algorithm>
#include <unordered_map>

#include "engines/solve/conclusions/separations.h"
#include "engines/solve/conclusions/sum_conflict.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

TracingOptions going_on(TracingOptions options) {
  options.limits.keep_going = true;
  options.diverse = false;
  return options;
}

bool nothing_firm(const Term&) { return false; }

}  // namespace

ConditionSolver::ConditionSolver(const Program& program, const ParamValues& params,
                                 const TracingOptions& options, Choices& choices, AddressTable& addresses,
                                 Pins& pins)
    : pins_(pins), solver_(program, params, going_on(options), choices, graph_, addresses, nothing_firm) {}

const std::vector<TracedCondition>& ConditionSolver::all() {
  solver_.explore();
  if (traced_pass_ != solver_.passes()) {
    traced_ = conditions_of(graph_, solver_.pass(), pins_);
    traced_pass_ = solver_.passes();
  }
  return traced_;
}

std::vector<ConditionSolver::Part> ConditionSolver::parts_of(const Wanted& wanted, Grain grain) {
  std::vector<Part> parts;
  const Condition* last = nullptr;
  for (const TracedCondition& each : all()) {  // in the order of their places
    if (!wanted(each.condition)) continue;
    const bool goes_on = grain == Grain::kAll ||
                         (grain == Grain::kPlaces && last != nullptr && last->span == each.condition.span);
    if (!goes_on || last == nullptr) parts.emplace_back();
    last = &each.condition;
    parts.back().holds = graph_.conjunction(parts.back().holds, each.holds);
    parts.back().conditions.push_back(last);
  }
  return parts;
}

ConditionSolver::Outcome ConditionSolver::find(const Wanted& wanted, const std::function<NodeId()>& also,
                                               Ends ends, Grain grain) {
  const auto conditions = [&] {
    asked_ = parts_of(wanted, grain);
    std::vector<NodeId> nodes;
    for (const Part& part : asked_) nodes.push_back(part.holds);
    if (also) nodes.push_back(graph_.disjunction(also(), solver_.unexplored()));
    return nodes;
  };
  return solver_.find(conditions, ends);
}

ConditionSolver::Outcome ConditionSolver::find(const Conditions& wanted, Grain grain) {
  return find([&](const Condition& each) { return wanted.count(each) != 0; }, nullptr, Ends::kErrorsAndCuts,
              grain);
}

ConditionSolver::Conditions ConditionSolver::core() {
  std::unordered_map<NodeId, const Part*> by_node;
  for (const Part& part : asked_) by_node.try_emplace(part.holds, &part);
  Conditions members;
  for (const NodeId node : solver_.core()) {
    const auto it = by_node.find(node);
    if (it == by_node.end()) continue;
    for (const Condition* condition : it->second->conditions) members.insert(*condition);
  }
  return members;
}

std::size_t ConditionSolver::inexpressible() {
  all();
  const auto& program_errors = solver_.trace().program_errors;
  return static_cast<std::size_t>(std::count_if(
      program_errors.begin(), program_errors.end(),
      [](const TraceProgramError& error) { return error.origin != TraceProgramError::Origin::kProgram; }));
}

std::optional<OverFull> ConditionSolver::over_full(const Conditions& conditions) {
  std::vector<NodeId> nodes;
  for (const TracedCondition& each : all()) {
    if (conditions.count(each.condition) != 0) nodes.push_back(each.holds);
  }
  const Separations separations = find_separations(graph_, nodes);
  std::vector<OverFull> found = find_over_full(graph_, separations);
  return found.empty() ? find_sum_conflict(graph_, separations.comparisons) : std::move(found.front());
}

std::set<AddressId> ConditionSolver::choices_below(const Conditions& conditions) {
  std::vector<NodeId> nodes;
  std::set<AddressId> addresses;
  for (const TracedCondition& each : all()) {
    if (conditions.count(each.condition) == 0) continue;
    nodes.push_back(each.holds);
    if (each.condition.pin != nullptr) addresses.insert(each.condition.address);
  }
  for (const std::size_t number : variables_below(graph_, nodes))
    addresses.insert(graph_.variables()[number].address);
  return addresses;
}

}  // namespace solitaire
