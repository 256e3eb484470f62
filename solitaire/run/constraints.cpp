#include "solitaire/run/constraints.h"

#include <fmt/format.h>

namespace solitaire {
namespace {

/// Returns true if an execution can go on where such a constraint fails.
bool can_be_broken(ConstraintKind kind) {
  switch (kind) {
    case ConstraintKind::kAssert:
    case ConstraintKind::kLowEnd:
    case ConstraintKind::kHighEnd:
    case ConstraintKind::kStep:
      return true;
    case ConstraintKind::kNotEmpty:
    case ConstraintKind::kIndex:
    case ConstraintKind::kDivisor:
      return false;
  }
  return false;
}

/// The last step of a constraint's address.
const char* label_of(ConstraintKind kind) {
  switch (kind) {
    case ConstraintKind::kAssert:
      return "assert";
    case ConstraintKind::kLowEnd:
    case ConstraintKind::kHighEnd:
    case ConstraintKind::kStep:
    case ConstraintKind::kNotEmpty:
      return "range";
    case ConstraintKind::kIndex:
      return "index";
    case ConstraintKind::kDivisor:
      return "divide";
  }
  return "";
}

}  // namespace

/// Conditions that may be broken are told of, and then it helps to know in which turn.
std::string Constraints::turn_text() const { return forks_ && limits_.keep_going ? loops_in_words() : ""; }

AddressId Constraints::constraint_address(ConstraintKind kind) {
  return address_of(addresses_.label(label_of(kind)));
}

void Constraints::reject(ConstraintKind kind, Span span, const std::string* message,
                         std::optional<AddressId> at) {
  if (!effects_->is_apart()) {
    const AddressId address = at ? *at : constraint_address(kind);
    effects_->constraint({kind, address, span, span, message, false}, false);
  }
  end_path();
}

void Constraints::require_open(const Value& given, ConstraintKind kind, Span span, const std::string* message,
                               std::optional<AddressId> at) {
  const Value condition = settle(given);
  const bool* known = condition.get<bool>();
  if (known != nullptr && *known && !condition.traced()) return;
  const AddressId address = at ? *at : constraint_address(kind);
  const bool goes_on = limits_.keep_going && can_be_broken(kind);
  if (known != nullptr && !*known && !condition.traced() && !goes_on) reject(kind, span, message, address);
  if (known == nullptr) check_condition(node_of(*graph_, condition), span);
  effects_->constraint({kind, address, span, span, message, goes_on, turn_text()}, condition);
  if (goes_on) return;
  if (known != nullptr) {
    if (!*known) end_path();
    return;
  }
  const NodeId node = node_of(*graph_, condition);
  if (limits_.keep_going) {  // nothing says that it holds, but executions in which it does not end here
    ++path_.losses.ends;
    path_.narrow(node);
  }
  path_.facts.assume(node, true);  // of the others nothing is asked any more
}

void Constraints::note_broken(const Value& given, Span span, Span whole, const std::string* message) {
  const Value settled = settle(given);
  const bool* known = settled.plain<bool>();
  if (known != nullptr && *known && !forks_) return;
  const Value& condition = known != nullptr && *known ? settled : given;
  if (condition.is<Symbol>()) check_condition(node_of(*graph_, condition), span);
  effects_->constraint({ConstraintKind::kAssert, constraint_address(ConstraintKind::kAssert), span, whole,
                        message, true, turn_text()},
                       condition);
}

void Constraints::end_where(const Value& wrong, Span span, const std::string& message) {
  const Value condition = settle(this->condition(wrong, span));
  if (condition.is<bool>()) {
    if (follow(condition, span)) program_error(span, message);
    return;
  }
  const NodeId node = node_of(*graph_, condition);
  if (graph_->node(node).has_float) return effects_->needs_execution();
  const std::array guards = {node, graph_->negation(node)};
  Value none;
  split(guards, {}, none, [&](std::size_t side, Value&) {
    if (side == 0) program_error(span, message);
    return true;
  });
  path_.facts.assume(guards[1], true);
}

Value Constraints::checked_condition(const Value& value, Span span) {
  return each_shape(value, [&](const Value& one) {
    if (!one.has_type(Type::kBool)) {
      program_error(span, fmt::format("a condition is true or false, not {}", describe(one)),
                    one.has_type(Type::kInt) ? "compare it with something: x != 0" : "");
    }
    return one;
  });
}

}  // namespace solitaire
