#pragma once
#include <cstdint>
#include <optional>

#include "tracegraph/graph.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// Who answers a choice: the seam by which one evaluator serves every engine. A replay answers with a
/// solution's values, a random run with random ones, a symbolic pass with none.
class Choices {
 public:
  virtual ~Choices() = default;
  /// A value of the domain for the choice at that address, or nothing to leave it open. Where the domain has
  /// symbolic ends it is the smallest that holds all of its possible values.
  virtual std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) = 0;
  /// What a choice that is left open can be at most: its domain, or more of the same kind, with the same
  /// step or 1. Then the ends of the domain, and a step that is not the same, are requirements.
  virtual Distribution widened(AddressId, const Distribution& domain) { return domain; }
};

/// Leaves every choice open.
class OpenChoices : public Choices {
 public:
  std::optional<TypedScalar> answer(AddressId, const Distribution&) override { return std::nullopt; }
};

/// What to do at a condition that is not decided: the other seam.
class Branches {
 public:
  virtual ~Branches() = default;
  /// Whether to go into this side, `levels` being what the side around it was granted. Nothing: it stays
  /// closed and becomes a blocker. A number: it is open, and sides right below it are offered with that
  /// number of levels.
  virtual std::optional<std::uint32_t> open(const BranchSide& side, std::uint32_t levels) = 0;
  /// Told of every branch that a concrete execution takes.
  virtual void taken(const BranchSide&) {}
};

}  // namespace solitaire
