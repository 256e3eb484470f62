#pragma once
#include "solitaire/run/structures.h"

namespace solitaire {

/// What an evaluation is to the builtins: all that they can ask for. The layers below it are structures.h,
/// operators.h, constraints.h, control.h and machine.h; the walk over the tree (walk.h) stands on it.
class Evaluator : public Structures {
 public:
  /// The value of a choice among the ints from lo in steps up to hi. `kind` is a distribution of the family,
  /// with other ends.
  Value decide(const CallExpr& site, const Value& lo, const Value& hi, const Value& step,
               const Distribution& kind);
  /// The value of a choice among the floats of a distribution. `name` is the builtin's, for the message where
  /// nobody answers it.
  Value draw(const CallExpr& site, const Distribution& distribution, const char* name);
  /// A wish of the program: executions that come here cost so much, an int.
  void wish(const Value& cost, const CallExpr& site);
  void place(Placement placement, const BuiltinCall& call);
  /// Reports what stands in the place of an assert's message and is no text.
  void check_message(const Value& message, Span span);

 protected:
  using Structures::Structures;

  Choices* choices_ = nullptr;

 private:
  Value decide_open(const CallExpr& site, AddressId address, const Value& lo, const Value& hi,
                    const Value& step, const Distribution& kind);
  TypedScalar answered(AddressId address, const Distribution& domain);
  void require_between(const Value& variable, const Value& lo, const Value& hi, Span span, AddressId address);
};

/// What an assert says of itself.
inline std::string message_of(const Value& message) {
  const auto* text = message.object<String>();
  return text != nullptr ? text->text : to_text(message);
}

}  // namespace solitaire
