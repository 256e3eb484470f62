// Which choices decide where a placed thing stands and what it is, and whether an assert is broken: those in
// the cone of the nodes that these depend on.
#include <algorithm>

#include "engines/solve/wide_trace.h"
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
        choices.push_back({addresses_.text(address), choice->second->domain.family, choice->second->value});
    }
  }
}

/// Of asserts that a solution breaks.
void TracingEngine::add_broken_choices(Solution& solution) {
  for (Rejection& broken : solution.execution.broken) {
    std::set<std::string> choices;
    for (const TraceAssert& part : solver_.trace().asserts) {
      if (part.span != broken.span || addresses_.text(part.address) != broken.address) continue;
      choices.merge(choices_below(part));
    }
    broken.choices.assign(choices.begin(), choices.end());
  }
}

/// The addresses of the choices that an assert depends on.
std::set<std::string> TracingEngine::choices_below(const TraceAssert& part) {
  std::set<std::string> addresses;
  for (const std::size_t number : variables_below(graph_, {&part.condition, 1}))
    addresses.insert(addresses_.text(graph_.variables()[number].address));
  if (!addresses.empty()) return addresses;
  if (!wide_) wide_ = std::make_unique<WideTrace>(*this);
  const Condition condition{part.requirement, part.address, part.span, part.whole, "", nullptr, {}};
  for (const AddressId address : wide_->solver.choices_below({condition}))
    addresses.insert(addresses_.text(address));
  return addresses;
}

}  // namespace solitaire
