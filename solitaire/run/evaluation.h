#pragma once
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "solitaire/run/structures.h"

namespace solitaire {

/// A distribution as an evaluation knows it.
struct Prior {
  Distribution distribution;
  /// Its parameters as of log_density() (tracegraph/density.h), which can carry nodes. Of a range or an index
  /// without weights there are none: the ends are given beside it.
  std::vector<Value> parameters;
};

/// What an evaluation is to the builtins: all that they can ask for. The layers below it are structures.h,
/// operators.h, constraints.h, control.h and machine.h; the walk over the tree (walk.h) stands on it.
class Evaluator : public Structures {
 public:
  /// The value of a choice among the ints from lo in steps up to hi. `prior` is a distribution of the family,
  /// with other ends.
  Value decide(const CallExpr& site, const Value& lo, const Value& hi, const Value& step, const Prior& prior);
  /// The value of a choice among the floats or counts of a distribution. `name` is the builtin's, for the
  /// message where nobody answers it. `part` is the choice's number, where the call makes several.
  Value draw(const CallExpr& site, const Prior& prior, const char* name,
             std::optional<std::uint32_t> part = std::nullopt);
  /// Returns true if choices are answered by how probable they are, so that their distributions matter.
  bool weighs() const { return choices_->weighs(); }
  /// The logarithm of the density at a value of the family's type.
  Value log_density(const Prior& prior, const Value& x, Span span);
  /// The execution is weighted by a factor with this logarithm, a number. `name` is the builtin's.
  void factor(const CallExpr& site, const Value& log_weight, const char* name);
  /// A wish of the program: executions that come here cost so much, an int.
  void wish(const Value& cost, const CallExpr& site);
  void place(Placement placement, const BuiltinCall& call);
  /// Reports what stands in the place of an assert's message and is no text.
  void check_message(const Value& message, Span span);
  /// The list of what a function makes of each element, turn by turn; `site` is the call that asks for it.
  virtual Value map_list(const Value& function, const Value& list, const CallExpr& site) = 0;
  /// The list of the elements for which a function gives true.
  virtual Value filter_list(const Value& function, const Value& list, const CallExpr& site) = 0;

 protected:
  using Structures::Structures;
  ~Evaluator() = default;

  Choices* choices_ = nullptr;  // null in the output

 private:
  void check_may_choose(const CallExpr& site);
  Value decide_open(const CallExpr& site, AddressId address, const Value& lo, const Value& hi,
                    const Value& step, const Prior& prior);
  Distribution of_path(const Distribution& domain, const Value& lo, const Value& hi, const Value& step);
  std::vector<NodeId> parameter_nodes(const Prior& prior, std::initializer_list<Value> ends);
  std::vector<NodeId> nodes_of_numbers(std::span<const Value> numbers);
  TypedScalar answered(AddressId address, const Distribution& domain);
  void require_between(const Value& variable, const Value& lo, const Value& hi, Span span, AddressId address);
};

/// What an assert says of itself.
inline std::string message_of(const Value& message) {
  const auto* text = message.object<String>();
  return text != nullptr ? text->text : to_text(message);
}

}  // namespace solitaire
