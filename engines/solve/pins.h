#pragma once
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "solitaire/run/choices.h"
#include "tracegraph/address_pattern.h"

namespace solitaire {

/// A value that the user fixes, or rules out, for the choices whose addresses match a pattern.
struct Pin {
  AddressPattern pattern;
  std::int64_t value = 0;  // a bool as 0 or 1
  bool forbidden = false;  // the choices must not have the value, rather than have it
  std::string source;      // how the user said it, for messages: "--pin 'x=3'"
};

/// Knows which pins hold for which choices.
class Pins {
 public:
  Pins(std::vector<Pin> pins, const AddressTable& addresses)
      : pins_(std::move(pins)), addresses_(addresses) {}

  bool empty() const { return pins_.empty(); }
  /// Returns the pins that match the address.
  const std::vector<const Pin*>& at(AddressId address);
  /// Returns what a choice is pinned to, by the first pin that matches.
  std::optional<std::int64_t> value_at(AddressId address);
  /// Returns the pins that match none of the addresses.
  std::vector<const Pin*> unmatched(const std::vector<AddressId>& addresses);

 private:
  std::vector<Pin> pins_;
  const AddressTable& addresses_;
  std::unordered_map<AddressId, std::vector<const Pin*>> matches_;
};

/// Returns what a pattern that matches none of the addresses was probably meant to be, most likely first:
/// addresses, or where the pattern has a `**` at one of its ends, patterns that do match.
std::vector<std::string> nearest_patterns(const AddressPattern& pattern,
                                          const std::vector<std::vector<std::string>>& addresses,
                                          std::size_t count);

/// What a pin requires of a choice that it matches.
struct PinnedChoice {
  const Pin* pin;
  const TraceChoice* choice;
  NodeId holds;
};
/// Returns what the pins require of the choices of a trace.
std::vector<PinnedChoice> pinned_choices(Graph& graph, const Trace& trace, Pins& pins);

/// Answers choices with what they are pinned to, and leaves the others open.
class PinnedChoices : public Choices {
 public:
  explicit PinnedChoices(Pins& pins) : pins_(pins) {}
  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    const auto value = pins_.value_at(address);
    if (!value) return std::nullopt;
    return domain.typed(*value);
  }

 private:
  Pins& pins_;
};

}  // namespace solitaire
