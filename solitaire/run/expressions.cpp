#include <algorithm>
#include <fmt/format.h>

#include "solitaire/run/walk.h"

namespace solitaire {

Value Walk::expression(const Expr& node) {
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
      return binary_expression(static_cast<const BinaryExpr&>(node));
    case ExprKind::kLogical:
      return logical(static_cast<const LogicalExpr&>(node));
    case ExprKind::kCall:
      return call(static_cast<const CallExpr&>(node));
    case ExprKind::kIndex: {
      const auto& index = static_cast<const IndexExpr&>(node);
      Value objects, indices;
      const Value& object = operand(*index.object, objects);
      return element(object, operand(*index.index, indices), node.span);
    }
    case ExprKind::kField: {
      const auto& access = static_cast<const FieldExpr&>(node);
      Value objects;
      return field(operand(*access.object, objects), access);
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

/// Nothing that an expression evaluates assigns the variable that it names, so the reference holds while
/// other operands are evaluated.
const Value& Walk::operand(const Expr& node, Value& storage) {
  if (node.kind == ExprKind::kName) {
    const Binding& binding = static_cast<const NameExpr&>(node).binding;
    if (binding.kind == Binding::Kind::kLocal) {
      const Value& value = slot(binding.slot);
      if (!value.is<Value::Unset>() && value.as_union() == nullptr) return value;
    }
  }
  return storage = expression(node);
}

Value Walk::literal(const LiteralExpr& node) {
  if (const auto* i = std::get_if<std::int64_t>(&node.value)) return *i;
  if (const auto* text = std::get_if<std::string>(&node.value)) return Value::string(*text);
  if (const auto* b = std::get_if<bool>(&node.value)) return *b;
  if (const auto* d = std::get_if<double>(&node.value)) return *d;
  return Value::nil();
}

Value Walk::name(const NameExpr& node) {
  const Binding& binding = node.binding;
  switch (binding.kind) {
    case Binding::Kind::kLocal:
      return read(frame(), binding.slot, node);
    case Binding::Kind::kOuter: {
      const Frame* outer = &frame();
      for (std::uint32_t level = 0; level < binding.level; ++level) outer = outer->outer.get();
      note_read(*outer, binding.slot, outer->slots[binding.slot]);
      return read(*outer, binding.slot, node);
    }
    case Binding::Kind::kModule: {
      const Frame& top = *module_frames_[binding.level];
      note_read(top, binding.slot, top.slots[binding.slot]);
      return read(top, binding.slot, node);
    }
    case Binding::Kind::kBuiltin:
      return &builtins()[binding.level];
    case Binding::Kind::kUnresolved:
      break;
  }
  return Value::nil();
}

/// A variable's value; an error of the program on the paths that did not assign it.
Value Walk::read(const Frame& frame, Slot slot, const NameExpr& node) {
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

Value Walk::list(const ListExpr& node) {
  std::vector<Value> items;
  items.reserve(node.items.size());
  for (const ExprPtr& item : node.items) items.push_back(expression(*item));
  return make_list(std::move(items), node.span);
}

Value Walk::unary_expression(const UnaryExpr& node) {
  if (node.op == UnaryOp::kNot) return invert(tested(*node.operand));
  Value storage;
  return negated(operand(*node.operand, storage), node.span);
}

Value Walk::binary_expression(const BinaryExpr& node) {
  Value lefts, rights;
  const Value& left = operand(*node.left, lefts);
  const Value& right = operand(*node.right, rights);
  switch (node.op) {
    case BinaryOp::kEqual:
      return equal(left, right, node.span);
    case BinaryOp::kNotEqual:
      return invert(equal(left, right, node.span));
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

Value Walk::logical(const LogicalExpr& node) {
  const Value left = tested(*node.left);
  const auto right = [&] { return tested(*node.right); };
  const auto settled = [&] { return Value(!node.is_and); };
  if (node.is_and) return choose_side(left, node.site, node.left->span, node.assigned, right, settled);
  return choose_side(left, node.site, node.left->span, node.assigned, settled, right);
}

Value Walk::if_expression(const IfExpr& node) {
  return choose_side(
      tested(*node.condition), node.site, node.condition->span, node.assigned,
      [&] { return expression(*node.then_value); }, [&] { return expression(*node.else_value); });
}

Value Walk::function(const FunctionExpr& node) {
  const bool top_level = current_->function == &program_.top(current_->module);
  return make_ref<Closure>(node.function.get(), top_level ? Ref<Frame>() : current_->frame, current_->module);
}

/// Runs an assert whose conjuncts are looked at one by one; false if its arguments are not as they should be.
bool Walk::assert_apart(const CallExpr& node) {
  const auto& given = node.arguments;
  const bool by_position =
      std::all_of(given.begin(), given.end(), [](const Argument& argument) { return argument.name.empty(); });
  if (!by_position || given.empty() || given.size() > 2) return false;
  std::string message;
  if (given.size() == 2) {
    const Value why = expression(*given[1].value);
    check_message(why, given[1].value->span);
    message = message_of(why);
  }
  assert_conjuncts(*given[0].value, given[0].value->span, message);
  return true;
}

void Walk::assert_conjuncts(const Expr& condition, Span whole, const std::string& message) {
  if (condition.kind == ExprKind::kLogical) {
    const auto& logical = static_cast<const LogicalExpr&>(condition);
    if (logical.is_and) {
      assert_conjuncts(*logical.left, whole, message);
      return assert_conjuncts(*logical.right, whole, message);
    }
  }
  note_broken(truth_apart([&] { return tested(condition); }), condition.span, whole, &message);
}

}  // namespace solitaire
