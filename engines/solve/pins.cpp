#include "engines/solve/pins.h"

#include <algorithm>
#include <fmt/format.h>

#include "base/nearest_name.h"

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
  if (pins_.empty()) return std::nullopt;
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

std::vector<std::string> nearest_patterns(const AddressPattern& pattern,
                                          const std::vector<std::vector<std::string>>& addresses,
                                          std::size_t count) {
  std::vector<std::string> steps = pattern.steps();
  const bool any_start = steps.size() > 1 && steps.front() == "**";
  const bool any_end = steps.size() > 1 && !any_start && steps.back() == "**";
  if (any_start) steps.erase(steps.begin());
  if (any_end) steps.pop_back();
  std::vector<std::string> candidates;
  for (const std::vector<std::string>& address : addresses) {
    const std::size_t left_out = address.size() - std::min(address.size(), steps.size());
    const auto first = address.begin() + static_cast<std::ptrdiff_t>(any_start ? left_out : 0);
    const auto last = address.end() - static_cast<std::ptrdiff_t>(any_end ? left_out : 0);
    candidates.push_back(fmt::format("{}", fmt::join(first, last, "/")));
  }
  std::vector<std::string> nearest =
      nearest_names(fmt::format("{}", fmt::join(steps, "/")), std::move(candidates), count);
  for (std::string& each : nearest) each = (any_start ? "**/" : "") + each + (any_end ? "/**" : "");
  return nearest;
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
