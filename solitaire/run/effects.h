#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "solitaire/builtins/builtin.h"
#include "solitaire/run/execution.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// Something that has to hold in every solution.
struct Constraint {
  ConstraintKind kind = ConstraintKind::kAssert;
  AddressId address;
  Span span;   // of the condition; where asserts are taken apart, of a conjunct of it
  Span whole;  // of the whole condition
  const std::string* message = nullptr;  // the author's, or null
  bool goes_on = false;                  // whether executions go on where it does not hold
  std::string turn = "";                 // the variables of the loops around it, as of a Term
};

/// Receives what an evaluation does beside computing values: the one place where an execution, a symbolic
/// pass and a traced execution differ. Everything happens on the current path.
class Effects {
 public:
  virtual ~Effects() = default;

  /// The next choice is one among the positions of that list.
  virtual void choosing_from(const Value&) {}
  /// A choice was answered by `value`, or stays open as the node `value`.
  virtual void choice(const TraceChoice& choice, const Value& value) = 0;
  /// A condition that is not known to hold, or that is traced.
  virtual void constraint(const Constraint& constraint, const Value& condition) = 0;
  /// A wish that costs so much, an int. Returns false if the costs grew too large.
  virtual bool wish(AddressId address, Span span, const Value& cost) = 0;
  /// The execution is weighted by a factor, whose natural logarithm this is: a float.
  virtual void factor(Span span, const Value& log_weight) = 0;
  /// A call of place(). `placement` is of no use where arguments depend on choices that are left open.
  virtual void placement(Placement placement, const BuiltinCall& call) = 0;
  /// The length of a unit from here on, in metres.
  virtual void unit(double metres) = 0;
  /// Choices decide about the length of a unit from here on; only an execution shows it.
  virtual void unit_is_open() { needs_execution(); }
  /// Returns the length of a unit here, nothing where choices decide about it.
  virtual std::optional<double> unit() const = 0;
  /// The last choices, width times height of them, are the sites of a map of tiles, row by row from the top.
  virtual void tile_map(std::int64_t /*width*/, std::int64_t /*height*/, const Value& /*source*/) {}
  /// What a map of tiles asks of two neighbours, as the table of its set says.
  virtual void tile_neighbors(const Value& /*condition*/) {}
  virtual void print(std::span<const Value> arguments) = 0;
  /// Only an execution shows what happens here.
  virtual void needs_execution() {}
  /// Values of different kinds were compared for equality, which they never have.
  virtual void compared_unlike(Span) {}
  /// A branch was taken because of a traced condition.
  virtual void followed(const Value& condition, Span span) = 0;
  /// The path ends since that side is closed.
  virtual void blocked(const BranchSide& side, Span span) = 0;
  /// The path ends since the program is wrong here; throws ProgramError where there is but one path.
  virtual void program_error(const Diagnostic& diagnostic, AddressId address) = 0;
  /// The path ends since the evaluation cannot go on here, though an execution might.
  virtual void unsupported(const Diagnostic& diagnostic, AddressId address,
                           TraceProgramError::Origin origin) = 0;
  /// The recorder whose segments stand for calls that several paths share; null where there is one path only.
  virtual TraceRecorder* segments() { return nullptr; }
  /// Returns true if this belongs to a condition that is looked at by itself.
  virtual bool is_apart() const { return false; }
};

}  // namespace solitaire
