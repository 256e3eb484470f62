#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solitaire/builtins/builtin.h"
#include "solitaire/run/execution.h"

namespace solitaire {

/// The checks that the arguments of place() have to pass.
class PlacementChecks {
 public:
  virtual ~PlacementChecks() = default;
  using Read = std::function<void(const Value&)>;
  using Message = std::function<std::string()>;

  /// Reads every shape that a value can have, none of which is a union.
  virtual void each_shape(const Value& value, const Read& read) = 0;
  /// The program is wrong.
  [[noreturn]] virtual void fail(Span span, const std::string& message) = 0;
  /// The program is wrong unless the number is above 0.
  virtual void check_positive(const Value& number, Span span, const Message& message) = 0;
  /// The program is wrong unless the number lies between 0 and 1.
  virtual void check_part(const Value& number, Span span, const Message& message) = 0;
  /// Returns the names of the materials that there are; null where that is not to be checked.
  virtual const std::vector<std::string>* materials() = 0;
};

/// Reads a placement from the arguments of a call of place(). Where they depend on choices that are left
/// open, all that they can be is checked, and what is returned is of no use.
Placement read_placement(const BuiltinCall& call, PlacementChecks& checks);
/// Reads a placement from arguments that have been checked, and that depend on no open choices.
Placement read_placement(const BuiltinCall& call);

}  // namespace solitaire
