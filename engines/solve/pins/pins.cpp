#include "engines/solve/pins/pins.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unordered_set>

#include "base/nearest_name.h"
#include "engines/elements.h"
#include "solitaire/value/chosen_list.h"
#include "solitaire/value/short_text.h"

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
  // Where a family has no ends, nothing else says which values it has.
  if (!choice.domain.is_finite() && !choice.domain.contains(value)) return kFalse;
  if (value.type() == Type::kFloat)
    return graph.apply(Op::kEqFloat, {choice.variable, graph.constant(value.as_float())});
  return graph.apply(Op::kEqInt, {choice.variable, graph.constant(value.as_int())});
}

/// Returns true if the pin's number means a position in the list, and not one of its elements.
bool is_position(const Pin& pin, const List& list) {
  return pin.value && pin.value->type() == Type::kInt && std::ranges::none_of(list.items, &Value::is_number);
}

/// Returns the condition that an element is the one that the pin says.
NodeId is_meant(Graph& graph, const Value& element, const Pin& pin) {
  if (element.is<ChosenList>()) return is_meant(graph, of_each_length(graph, element), pin);
  if (const Union* several = element.as_union()) {
    NodeId any = kFalse;
    for (const auto& [guard, value] : several->alternatives)
      any = graph.disjunction(any, graph.conjunction(guard, is_meant(graph, value, pin)));
    return any;
  }
  const auto* symbol = element.get<Symbol>();
  if (symbol == nullptr) return means_element(pin.element, short_text(element)) ? kTrue : kFalse;
  const auto value = pin.value ? converted(*pin.value, symbol->type) : std::nullopt;
  if (!value || symbol->type == Type::kFloat) return kFalse;
  if (symbol->type == Type::kInt)
    return graph.apply(Op::kEqInt, {symbol->node, graph.constant(value->as_int())});
  return value->as_int() != 0 ? symbol->node : graph.negation(symbol->node);
}

/// Returns the condition that the pin means what stands at the chosen position of a list.
NodeId has_element(Graph& graph, const Value& list, const TraceChoice& choice, const Pin& pin) {
  if (list.is<ChosenList>()) return has_element(graph, of_each_length(graph, list), choice, pin);
  NodeId any = kFalse;
  if (const Union* several = list.as_union()) {
    for (const auto& [guard, value] : several->alternatives)
      any = graph.disjunction(any, graph.conjunction(guard, has_element(graph, value, choice, pin)));
    return any;
  }
  const List* known = list.as_list();
  if (known == nullptr) return kFalse;
  if (is_position(pin, *known)) return has_value(graph, choice, *pin.value);
  for (std::size_t i = 0; i < known->items.size(); ++i) {
    const NodeId here = has_value(graph, choice, TypedScalar::of(static_cast<std::int64_t>(i)));
    any = graph.disjunction(any, graph.conjunction(here, is_meant(graph, known->items[i], pin)));
  }
  return any;
}

/// Returns true for choose(), of which a list is known, and not for categorical().
bool is_from_list(const SymbolicPass& pass, const TraceChoice& choice) {
  return choice.list < pass.lists.size() && !pass.lists[choice.list].is<Value::Nil>();
}

/// Returns the condition that a choice has what a pin says.
NodeId is_kept(Graph& graph, const SymbolicPass& pass, const TraceChoice& choice, const Pin& pin) {
  if (is_from_list(pass, choice) && !pin.element.empty())
    return has_element(graph, pass.lists[choice.list], choice, pin);
  const auto fitting = pin.value ? converted(*pin.value, choice.domain.type()) : std::nullopt;
  return fitting ? has_value(graph, choice, *fitting) : kFalse;
}

/// Returns the element that a pin means, as the language writes it, or "".
std::string said_element(const SymbolicPass& pass, const PinnedChoice& pinned) {
  const List* list = pass.lists[pinned.choice->list].as_list();
  for (std::size_t i = 0; list != nullptr && i < list->items.size(); ++i) {
    std::string text = short_text(list->items[i]);
    if (means_element(pinned.pin->element, text)) return text;
  }
  if (list == nullptr || !is_position(*pinned.pin, *list)) return "";
  return element_at(pass, *pinned.choice, pinned.pin->value->as_int());
}

}  // namespace

std::vector<PinnedChoice> pinned_choices(Graph& graph, const SymbolicPass& pass, Pins& pins) {
  std::vector<PinnedChoice> pinned;
  if (pins.empty()) return pinned;
  for (const TraceChoice& choice : pass.trace.choices) {
    for (const Pin* pin : pins.at(choice.address)) {
      const NodeId equal = is_kept(graph, pass, choice, *pin);
      const NodeId wanted = pin->forbidden ? graph.negation(equal) : equal;
      pinned.push_back({pin, &choice, graph.implication(choice.guard, wanted)});
    }
  }
  return pinned;
}

std::string element_at(const SymbolicPass& pass, const TraceChoice& choice, std::int64_t position) {
  const List* list = choice.list < pass.lists.size() ? pass.lists[choice.list].as_list() : nullptr;
  const auto number = static_cast<std::size_t>(position);
  return list == nullptr || number >= list->items.size() ? "" : short_text(list->items[number]);
}

std::string pinned_text(const SymbolicPass& pass, const PinnedChoice& pinned) {
  const TraceChoice& choice = *pinned.choice;
  const Pin& pin = *pinned.pin;
  std::string element;
  if (is_from_list(pass, choice))
    element =
        pin.element.empty() ? element_at(pass, choice, pin.value->as_int()) : said_element(pass, pinned);
  if (!element.empty()) return element;
  const auto value = pin.value ? converted(*pin.value, choice.domain.type()) : std::nullopt;
  return value ? to_text(*value) : pin.element;
}

std::string possible_text(const SymbolicPass& pass, const TraceChoice& choice) {
  const Distribution& domain = choice.domain;
  if (domain.family == Distribution::Family::kIndex) {
    const std::string elements = is_from_list(pass, choice) ? elements_text(pass.lists[choice.list]) : "";
    return elements.empty() ? fmt::format("a position from 0 to {}", domain.hi) : "one of " + elements;
  }
  if (domain.family == Distribution::Family::kUniform)
    return fmt::format("from {} to {}", domain.a, domain.b);
  if (domain.type() != Type::kInt || !domain.is_finite()) return "";
  return fmt::format("from {} to {}", domain.lo, domain.hi) +
         (domain.step > 1 ? fmt::format(" in steps of {}", domain.step) : "");
}

}  // namespace solitaire
