#include "engines/tile_maps/derived_choices.h"

#include <algorithm>
#include <deque>
#include <unordered_map>

namespace solitaire {
namespace {

/// Each definition may be evaluated so often, beside a few.
constexpr std::size_t kMostTurns = 50, kAFew = 1000;

}  // namespace

DerivedChoices::DerivedChoices(const Graph& graph, const Trace& trace, const LiveConditions& conditions)
    : definition_of_(conditions.conditions().size(), SIZE_MAX) {
  std::unordered_map<NodeId, const TraceChoice*> auxiliary;
  for (const TraceChoice& choice : trace.choices) {
    if (choice.auxiliary && graph.node(choice.variable).op == Op::kChoice)
      auxiliary.emplace(choice.variable, &choice);
  }
  for (std::size_t number = 0; number < definition_of_.size(); ++number) {
    const Graph::Node& node = graph.node(conditions.conditions()[number]);
    if (node.op != Op::kEqInt) continue;
    for (const std::size_t side : {0, 1}) {
      const auto found = auxiliary.find(node.operands.at(side));
      if (found == auxiliary.end()) continue;
      const Distribution& domain = found->second->domain;
      definition_of_[number] = definitions_.size();
      definitions_.push_back({found->first, node.operands.at(1 - side), domain.lo, domain.hi, number});
      auxiliary.erase(found);  // a second definition is a condition like others
      break;
    }
  }
}

void DerivedChoices::settle(LiveConditions& conditions) const {
  conditions.settle();
  if (!any_defines(conditions.take_broken())) return;
  begin_anew(conditions);
  follow(conditions);
}

bool DerivedChoices::any_defines(const std::vector<std::size_t>& conditions) const {
  return std::ranges::any_of(conditions,
                             [this](std::size_t each) { return definition_of_[each] != SIZE_MAX; });
}

void DerivedChoices::begin_anew(LiveConditions& conditions) const {
  for (const Definition& definition : definitions_)
    conditions.set(definition.variable, Scalar::of(definition.hi));
  conditions.settle();
  conditions.take_broken();
}

void DerivedChoices::follow(LiveConditions& conditions) const {
  std::deque<std::size_t> waiting;
  for (std::size_t each = 0; each < definitions_.size(); ++each) {
    if (!conditions.holds(definitions_[each].condition)) waiting.push_back(each);
  }
  for (std::size_t turns = kMostTurns * definitions_.size() + kAFew; turns > 0 && !waiting.empty(); --turns) {
    const Definition& definition = definitions_[waiting.front()];
    waiting.pop_front();
    if (conditions.holds(definition.condition)) continue;
    const auto value = conditions.value(definition.value);
    if (!value) return;
    conditions.set(definition.variable, Scalar::of(std::clamp(value->i, definition.lo, definition.hi)));
    conditions.settle();
    for (const std::size_t broken : conditions.take_broken()) {
      if (definition_of_[broken] != SIZE_MAX) waiting.push_back(definition_of_[broken]);
    }
  }
}

}  // namespace solitaire
