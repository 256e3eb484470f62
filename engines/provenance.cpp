// Which choices decide where a placed thing stands and what it is: those in the cone of the nodes it depends
// on.
#include <algorithm>

#include "engines/tracing.h"
#include "tracegraph/cone.h"

namespace solitaire {
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
