// Which choices decide where a placed thing stands and what it is: those in the cone of the nodes it depends
// on.
#include <unordered_set>

#include "engines/tracing.h"

namespace solitaire {
namespace {

/// The variables of all choices that the nodes depend on, in the order of their numbers.
std::set<std::size_t> variables_below(const Graph& graph, const std::vector<NodeId>& nodes) {
  std::set<std::size_t> variables;
  std::unordered_set<NodeId> seen(nodes.begin(), nodes.end());
  std::vector<NodeId> pending(seen.begin(), seen.end());
  while (!pending.empty()) {
    const Graph::Node& node = graph.node(pending.back());
    pending.pop_back();
    if (node.op == Op::kChoice) variables.insert(node.payload);
    for (const NodeId operand : node.args()) {
      if (seen.insert(operand).second) pending.push_back(operand);
    }
  }
  return variables;
}

}  // namespace

void TracingEngine::add_object_choices(Solution& solution) {
  std::unordered_map<std::string, Placement*> placements;
  for (Placement& placement : solution.execution.placements)
    placements.emplace(placement.address, &placement);
  if (placements.empty()) return;
  std::unordered_map<AddressId, const MetChoice*> met;
  for (const MetChoice& choice : solution.choices) met.emplace(choice.address, &choice);

  for (const TracePlaced& placed : solver_.trace().placed) {
    const auto placement = placements.find(addresses_.text(placed.address));
    if (placement == placements.end()) continue;
    std::vector<AnsweredChoice>& choices = placement->second->choices;
    for (const std::size_t number : variables_below(graph_, placed.depends)) {
      const AddressId address = graph_.variables()[number].address;
      const auto choice = met.find(address);
      if (choice == met.end()) continue;  // of a path that this execution does not take
      const bool known = std::any_of(choices.begin(), choices.end(), [&](const AnsweredChoice& other) {
        return other.address == addresses_.text(address);
      });
      if (!known)
        choices.push_back({addresses_.text(address), choice->second->domain.kind, choice->second->value});
    }
  }
}

}  // namespace solitaire
