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
  /// Returns the domain of a choice that is left open: its own, or a wider one of the same family, with the
  /// same step or 1. If it is wider, the ends and the step become constraints of their own.
  virtual Distribution widened(AddressId, const Distribution& domain) { return domain; }
  /// Returns true if executions are asked for by how probable they are. Else it is an error of the program to
  /// weight them, since nobody would look at it.
  virtual bool weighs() const { return false; }
};

/// Leaves every choice open.
class OpenChoices : public Choices {
 public:
  std::optional<TypedScalar> answer(AddressId, const Distribution&) override { return std::nullopt; }
};

/// Decides what happens at a condition that is not known: the other seam.
class Branches {
 public:
  virtual ~Branches() = default;
  /// Decides whether to go into this side; `levels` is what the side around it was granted. Returns nothing
  /// if it stays closed and becomes a blocker. If it is open, returns the number of levels with which the
  /// sides right below it are offered.
  virtual std::optional<std::uint32_t> open(const BranchSide& side, std::uint32_t levels) = 0;
  /// Returns true if conditions that depend on floats that depend on choices are to be recorded like others.
  /// Else they are what the pass cannot express: no bit-vector says them.
  virtual bool takes_floats() const { return false; }
  /// Told of every branch that a concrete execution takes.
  virtual void taken(const BranchSide&) {}
};

}  // namespace solitaire
