#include "engines/solve/pins.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unordered_set>

#include "base/nearest_name.h"

namespace solitaire {

Pins::Pins(std::vector<Pin> pins, const AddressTable& addresses)
    : pins_(std::move(pins)), addresses_(addresses) {
  for (const Pin& pin : pins_)
    (pin.pattern.is_exact() ? exact_[pin.pattern.text()] : patterns_).push_back(&pin);
}

/// The pins of an address stay in the order in which they were given.
const std::vector<const Pin*>& Pins::at(AddressId address) {
  const auto [it, added] = matches_.try_emplace(address);
  if (!added || pins_.empty()) return it->second;
  std::vector<const Pin*>& matches = it->second;
  const std::vector<std::string> steps = addresses_.steps(address);
  const auto exact = exact_.find(fmt::format("{}", fmt::join(steps, "/")));
  if (exact != exact_.end()) matches = exact->second;
  for (const Pin* pin : patterns_) {
    if (pin->pattern.matches(steps)) matches.push_back(pin);
  }
  std::sort(matches.begin(), matches.end());
  return matches;
}

const Pin* Pins::fixing(AddressId address) {
  if (pins_.empty()) return nullptr;
  for (const Pin* pin : at(address)) {
    if (!pin->forbidden) return pin;
  }
  return nullptr;
}

std::vector<const Pin*> Pins::unmatched(const std::vector<AddressId>& addresses) {
  std::unordered_set<const Pin*> matched;
  for (const AddressId address : addresses) {
    const auto& pins = at(address);
    matched.insert(pins.begin(), pins.end());
  }
  std::vector<const Pin*> unmatched;
  for (const Pin& pin : pins_) {
    if (matched.count(&pin) == 0) unmatched.push_back(&pin);
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

namespace {

/// Returns the condition that a choice has that value.
NodeId has_value(Graph& graph, const TraceChoice& choice, TypedScalar value) {
  const auto fitting = converted(value, choice.domain.type());
  if (!fitting) return kFalse;
  // Where a family has no ends, nothing else says which values it has.
  if (!choice.domain.is_finite() && !choice.domain.contains(*fitting)) return kFalse;
  if (fitting->type() == Type::kFloat)
    return graph.apply(Op::kEqFloat, {choice.variable, graph.constant(fitting->as_float())});
  return graph.apply(Op::kEqInt, {choice.variable, graph.constant(fitting->as_int())});
}

}  // namespace

std::vector<PinnedChoice> pinned_choices(Graph& graph, const Trace& trace, Pins& pins) {
  std::vector<PinnedChoice> pinned;
  if (pins.empty()) return pinned;
  for (const TraceChoice& choice : trace.choices) {
    for (const Pin* pin : pins.at(choice.address)) {
      const NodeId equal = has_value(graph, choice, pin->value);
      const NodeId wanted = pin->forbidden ? graph.negation(equal) : equal;
      pinned.push_back({pin, &choice, graph.implication(choice.guard, wanted)});
    }
  }
  return pinned;
}

}  // namespace solitaire
