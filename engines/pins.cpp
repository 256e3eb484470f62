#include "engines/pins.h"

#include <algorithm>

namespace solitaire {

const std::vector<const Pin*>& Pins::at(AddressId address) {
  const auto [it, added] = matches_.try_emplace(address);
  if (added && !pins_.empty()) {
    const std::vector<std::string> steps = addresses_.steps(address);
    for (const Pin& pin : pins_) {
      if (pin.pattern.matches(steps)) it->second.push_back(&pin);
    }
  }
  return it->second;
}

std::optional<std::int64_t> Pins::value_at(AddressId address) {
  for (const Pin* pin : at(address)) {
    if (!pin->forbidden) return pin->value;
  }
  return std::nullopt;
}

std::vector<const Pin*> Pins::unmatched(const std::vector<AddressId>& addresses) {
  std::vector<const Pin*> unmatched;
  for (const Pin& pin : pins_) {
    const bool matched = std::any_of(addresses.begin(), addresses.end(), [&](AddressId address) {
      const auto& pins = at(address);
      return std::find(pins.begin(), pins.end(), &pin) != pins.end();
    });
    if (!matched) unmatched.push_back(&pin);
  }
  return unmatched;
}

std::vector<PinnedChoice> pinned_choices(Graph& graph, const Trace& trace, Pins& pins) {
  std::vector<PinnedChoice> pinned;
  if (pins.empty()) return pinned;
  for (const TraceChoice& choice : trace.choices) {
    for (const Pin* pin : pins.at(choice.address)) {
      const NodeId equal = graph.apply(Op::kEqInt, {choice.variable, graph.constant(pin->value)});
      const NodeId wanted = pin->forbidden ? graph.negation(equal) : equal;
      pinned.push_back({pin, &choice, graph.implication(choice.guard, wanted)});
    }
  }
  return pinned;
}

}  // namespace solitaire
