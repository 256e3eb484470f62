#pragma once
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "solitaire/run/choices.h"
#include "solitaire/run/symbolic_pass.h"
#include "tracegraph/address_pattern.h"
#include "tracegraph/scalar.h"

namespace solitaire {

/// A value that the user fixes, or rules out, for the choices whose addresses match a pattern.
struct Pin {
  AddressPattern pattern;
  std::optional<TypedScalar> value;  // of choose() a position; nothing if a text was said
  bool forbidden = false;            // the choices must not have the value, rather than have it
  std::string source;                // how the user said it, for messages: "--pin 'x=3'"
  /// Where it is not empty, the element that choose() is to have chosen, as somebody said it (elements.h). A
  /// number counts as a position all the same if the list has no numbers.
  std::string element = "";

  bool looks_at_list(const Distribution& domain) const {
    return domain.family == Distribution::Family::kIndex && !element.empty();
  }
  /// Returns the value that a choice has to have, where that is known without looking at a list.
  std::optional<TypedScalar> value_of(const Distribution& domain) const {
    return looks_at_list(domain) || !value ? std::nullopt : converted(*value, domain.type());
  }
};

/// Knows which pins hold for which choices.
///
/// Most pins name one address, such as those of a solution's file. They are found by its text, so that the
/// time for a choice does not depend on how many there are. Only patterns are tried one by one.
class Pins {
 public:
  Pins(std::vector<Pin> pins, const AddressTable& addresses);
  Pins(const Pins&) = delete;
  Pins& operator=(const Pins&) = delete;

  bool empty() const { return pins_.empty(); }
  /// Returns the pins that match the address.
  const std::vector<const Pin*>& at(AddressId address);
  /// Returns the first pin that matches and does not forbid a value, or null.
  const Pin* fixing(AddressId address);
  /// Returns the pins that match none of the addresses.
  std::vector<const Pin*> unmatched(const std::vector<AddressId>& addresses);

 private:
  std::vector<Pin> pins_;
  const AddressTable& addresses_;
  std::unordered_map<std::string, std::vector<const Pin*>> exact_;  // pins of one address, by its text
  std::vector<const Pin*> patterns_;                                // all other pins
  std::unordered_map<AddressId, std::vector<const Pin*>> matches_;
};

/// Returns what a pattern that matches none of the addresses was probably meant to be, most likely first:
/// addresses, or where the pattern has a `**` at one of its ends, patterns that do match.
std::vector<std::string> nearest_patterns(const AddressPattern& pattern,
                                          const std::vector<std::vector<std::string>>& addresses,
                                          std::size_t count);

/// A choice with a pin that matches it, and the condition that the pin is kept.
struct PinnedChoice {
  const Pin* pin;
  const TraceChoice* choice;
  NodeId holds;
};
/// Returns what the pins require of the choices of a pass.
std::vector<PinnedChoice> pinned_choices(Graph& graph, const SymbolicPass& pass, Pins& pins);
/// Says what a pin is about, as the language writes it: 3, true, "oven".
std::string pinned_text(const SymbolicPass& pass, const PinnedChoice& pinned);
/// Returns the text of the element at a position of the list from which a choice chooses, if that is the same
/// on all paths and short; else "".
std::string element_at(const SymbolicPass& pass, const TraceChoice& choice, std::int64_t position);
/// Says which values a choice can have: `one of "oven", "sink"`, "from 0 to 9"; "" where there is no telling.
std::string possible_text(const SymbolicPass& pass, const TraceChoice& choice);

/// Answers choices with what they are pinned to, and leaves open the others and those of another type than
/// their pin.
class PinnedChoices : public Choices {
 public:
  explicit PinnedChoices(Pins& pins) : pins_(pins) {}
  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    const Pin* pin = pins_.fixing(address);
    return pin == nullptr ? std::nullopt : pin->value_of(domain);
  }

 private:
  Pins& pins_;
};

/// Leaves choices open, but for pinned ones among infinitely many values, of which solvers find none.
class PinnedFloats : public PinnedChoices {
 public:
  using PinnedChoices::PinnedChoices;
  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    return domain.is_finite() ? std::nullopt : PinnedChoices::answer(address, domain);
  }
};

}  // namespace solitaire
