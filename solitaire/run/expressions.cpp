#include <algorithm>
#include <fmt/format.h>

#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

bool is_assert(const Value& callee) {
  static const Builtin* const assert_builtin = &builtins()[*find_builtin("assert")];
  const auto* builtin = callee.get<Value::BuiltinRef>();
  return builtin != nullptr && *builtin == assert_builtin;
}

}  // namespace

Value Evaluator::expression(const Expr& node) {
  switch (node.kind) {
    case ExprKind::kLiteral:
      return literal(static_cast<const LiteralExpr&>(node));
    case ExprKind::kName:
      return name(static_cast<const NameExpr&>(node));
    case ExprKind::kList:
      return list(static_cast<const ListExpr&>(node));
    case ExprKind::kUnary:
      return unary_expression(static_cast<const UnaryExpr&>(node));
    case ExprKind::kBinary:
      return binary(static_cast<const BinaryExpr&>(node));
    case ExprKind::kLogical:
      return logical(static_cast<const LogicalExpr&>(node));
    case ExprKind::kCall:
      return call(static_cast<const CallExpr&>(node));
    case ExprKind::kIndex: {
      const auto& index = static_cast<const IndexExpr&>(node);
      const Value object = expression(*index.object);
      return element(object, expression(*index.index), node.span);
    }
    case ExprKind::kField: {
      const auto& access = static_cast<const FieldExpr&>(node);
      return field(expression(*access.object), access);
    }
    case ExprKind::kIf:
      return if_expression(static_cast<const IfExpr&>(node));
    case ExprKind::kFunction:
      return function(static_cast<const FunctionExpr&>(node));
    case ExprKind::kComprehension:
      return comprehension(static_cast<const ComprehensionExpr&>(node));
    case ExprKind::kError:
      return Value::nil();  // a program with errors is never run
  }
  return {};
}

Value Evaluator::literal(const LiteralExpr& node) {
  struct ToValue {
    Value operator()(std::monostate) const { return Value::nil(); }
    Value operator()(bool b) const { return b; }
    Value operator()(std::int64_t i) const { return i; }
    Value operator()(double d) const { return d; }
    Value operator()(const std::string& text) const { return Value::string(text); }
  };
  return std::visit(ToValue{}, node.value);
}

Value Evaluator::name(const NameExpr& node) {
  const Binding& binding = node.binding;
  switch (binding.kind) {
    case Binding::Kind::kLocal:
      return read(*current_->frame, binding.slot, node);
    case Binding::Kind::kOuter: {
      const Frame* frame = current_->frame.get();
      for (std::uint32_t level = 0; level < binding.level; ++level) frame = frame->outer.get();
      note_read(*frame, binding.slot, frame->slots[binding.slot]);
      return read(*frame, binding.slot, node);
    }
    case Binding::Kind::kModule: {
      const Frame& frame = *module_frames_[binding.level];
      note_read(frame, binding.slot, frame.slots[binding.slot]);
      return read(frame, binding.slot, node);
    }
    case Binding::Kind::kBuiltin:
      return &builtins()[binding.level];
    case Binding::Kind::kUnresolved:
      break;
  }
  return Value::nil();
}

/// A variable's value; a mistake on the paths that did not assign it.
Value Evaluator::read(const Frame& frame, Slot slot, const NameExpr& node) {
  const Value& value = frame.slots[slot];
  if (!value.is<Value::Unset>() && value.as_union() == nullptr) return value;
  return each_shape(value, [&](const Value& one) {
    if (one.is<Value::Unset>()) {
      program_error(node.span, fmt::format("'{}' has no value yet", node.name),
                    "a name that a function assigns is its own; assign it before it is read");
    }
    return one;
  });
}

Value Evaluator::list(const ListExpr& node) {
  std::vector<Value> items;
  items.reserve(node.items.size());
  for (const ExprPtr& item : node.items) items.push_back(expression(*item));
  return make_list(std::move(items), node.span);
}

Value Evaluator::unary_expression(const UnaryExpr& node) {
  const Value operand = expression(*node.operand);
  if (node.op == UnaryOp::kNegate) return negated(operand, node.span);
  return value_of(graph_, graph_.negation(condition(operand, node.operand->span)));
}

Value Evaluator::binary(const BinaryExpr& node) {
  const Value left = expression(*node.left);
  const Value right = expression(*node.right);
  switch (node.op) {
    case BinaryOp::kEqual:
      return equal(left, right);
    case BinaryOp::kNotEqual:
      return invert(equal(left, right));
    case BinaryOp::kLess:
    case BinaryOp::kLessEqual:
    case BinaryOp::kGreater:
    case BinaryOp::kGreaterEqual:
      return compare(node.op, left, right, node.span);
    case BinaryOp::kUpTo:
      return up_to(left, right, node.span);
    default:
      return arithmetic(node.op, left, right, node.span);
  }
}

Value Evaluator::logical(const LogicalExpr& node) {
  const NodeId left = condition(expression(*node.left), node.left->span);
  const auto right = [&] { return value_of(graph_, condition(expression(*node.right), node.right->span)); };
  const auto settled = [&] { return Value(!node.is_and); };
  if (node.is_and) return choose_side(left, node.site, node.left->span, node.assigned, right, settled);
  return choose_side(left, node.site, node.left->span, node.assigned, settled, right);
}

Value Evaluator::if_expression(const IfExpr& node) {
  const NodeId holds = condition(expression(*node.condition), node.condition->span);
  return choose_side(
      holds, node.site, node.condition->span, node.assigned, [&] { return expression(*node.then_value); },
      [&] { return expression(*node.else_value); });
}

Value Evaluator::function(const FunctionExpr& node) {
  const bool top_level = current_->function == &program_.top(current_->module);
  return make_ref<Closure>(node.function.get(), top_level ? Ref<Frame>() : current_->frame, current_->module);
}

/// An assert whose conjuncts are looked at one by one; false if its arguments are not as they should be.
bool Evaluator::assert_apart(const CallExpr& node) {
  const auto& given = node.arguments;
  const bool by_position =
      std::all_of(given.begin(), given.end(), [](const Argument& argument) { return argument.name.empty(); });
  if (!by_position || given.empty() || given.size() > 2) return false;
  std::string message;
  if (given.size() == 2) {
    const Value why = expression(*given[1].value);
    message = why.object<String>() != nullptr ? why.object<String>()->text : to_text(why);
  }
  assert_conjuncts(*given[0].value, given[0].value->span, message);
  return true;
}

void Evaluator::assert_conjuncts(const Expr& condition, Span whole, const std::string& message) {
  if (condition.kind == ExprKind::kLogical) {
    const auto& logical = static_cast<const LogicalExpr&>(condition);
    if (logical.is_and) {
      assert_conjuncts(*logical.left, whole, message);
      return assert_conjuncts(*logical.right, whole, message);
    }
  }
  note(truth_of(condition), ConstraintKind::kAssert, condition.span, whole, message, address_of("assert"));
}

Value Evaluator::call(const CallExpr& node) {
  const Value callee = expression(*node.callee);
  if (limits_.keep_going && is_assert(callee) && assert_apart(node)) return Value::nil();
  std::vector<Value> positional;
  std::vector<std::pair<const Argument*, Value>> named;
  // They become the variables of the function.
  const Closure* closure = callee.object<Closure>();
  positional.reserve(closure != nullptr ? closure->function->slots.size() : node.arguments.size());
  for (const Argument& argument : node.arguments) {
    if (argument.name.empty()) {
      if (!named.empty())
        program_error(argument.value->span, "an argument by position stands behind a named one");
      positional.push_back(expression(*argument.value));
    } else {
      named.emplace_back(&argument, expression(*argument.value));
    }
  }
  return call_value(callee, node, std::move(positional), std::move(named));
}

}  // namespace solitaire
