#pragma once
#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "engines/solve/pins/pins.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// A single condition of a program, as its author sees it: a conjunct of an assert, an end of a choice's
/// range, a list that must have an element, or a pin; at one address, so of one call and loop turn.
struct Condition {
  ConstraintKind requirement = ConstraintKind::kAssert;  // means nothing for a pin
  AddressId address;
  Span span;
  Span whole;           // the whole condition of an assert
  std::string message;  // the author's, or ""
  std::string turn;     // the variables of the loops around it that are known: "x = 3, y = 1"
  const Pin* pin = nullptr;
  std::optional<Distribution> domain;  // the choice's; for pins, and for ends that depend on no choice
  std::string pinned = "";             // of a pin: what it is about, as pinned_text() says
  std::string possible = "";           // of a pin that no value of the choice fulfils: which there are
  bool unlike = false;  // of an assert that compares values of different kinds, and so never holds

  /// Two conditions are equal if they are the same one in every pass, whatever is known about them.
  friend bool operator==(const Condition& a, const Condition& b) { return a.key() == b.key(); }
  friend bool operator<(const Condition& a, const Condition& b) { return a.key() < b.key(); }

 private:
  std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, const Pin*, AddressId, ConstraintKind> key() const {
    return {span.source, span.begin, span.end, pin, address, requirement};
  }
};

/// Returns true for a condition about a choice's range: an end, or the steps.
bool is_end(ConstraintKind requirement);

/// A condition, where a trace says when it holds.
struct TracedCondition {
  Condition condition;
  NodeId holds = kTrue;
  NodeId met = kFalse;  // holds in executions that come to it
};

/// Returns all conditions of a pass whose asserts are taken apart, each once, in the order of the program's
/// text. One that holds in all executions is among them too.
std::vector<TracedCondition> conditions_of(Graph& graph, const SymbolicPass& pass, Pins& pins);

}  // namespace solitaire
