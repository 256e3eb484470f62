#include <span>

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
    case ExprKind::kIndex:
      return element_of(static_cast<const IndexExpr&>(node));
    case ExprKind::kField:
      return field_of(static_cast<const FieldExpr&>(node));
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

Value Walk::element_of(const IndexExpr& node) {
  Value objects, indices;
  const Value& object = operand(*node.object, objects);
  return element(object, operand(*node.index, indices), node.span);
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
  if (node.op == BinaryOp::kIn) return membership(node);
  Value lefts, rights;
  const Value& left = operand(*node.left, lefts);
  const Value& right = operand(*node.right, rights);
  if (node.op == BinaryOp::kUpTo) return up_to(left, right, node.span);
  return operate(node.op, left, right, node.span);
}

/// `x in list`. Of `x in a..b` no list is made where all are ints.
Value Walk::membership(const BinaryExpr& node) {
  const Value value = expression(*node.left);
  const auto* ints =
      node.right->kind == ExprKind::kBinary ? static_cast<const BinaryExpr*>(node.right.get()) : nullptr;
  if (ints == nullptr || ints->op != BinaryOp::kUpTo) {
    return with_list(expression(*node.right), "in", node.right->span,
                     [&](const Value& list) { return is_among(list, value, node.span); });
  }
  const Value first = expression(*ints->left);
  const Value last = expression(*ints->right);
  if (value.has_type(Type::kInt) && first.has_type(Type::kInt) && last.has_type(Type::kInt)) {
    return both(compare(BinaryOp::kLessEqual, first, value, node.span),
                compare(BinaryOp::kLessEqual, value, last, node.span));
  }
  return with_list(up_to(first, last, node.right->span), "in", node.right->span,
                   [&](const Value& list) { return is_among(list, value, node.span); });
}

Value Walk::logical(const LogicalExpr& node) {
  const Value left = settle(tested(*node.left));
  if (const Value* right = left.is<bool>() ? nullptr : bool_at_hand(*node.right)) {
    check_condition(node_of(*graph_, left), node.left->span);
    return node.is_and ? both(left, *right) : either(left, *right);
  }
  const auto right = [&] { return tested(*node.right); };
  if (node.computes && shows_both_sides(left)) {
    Aside aside;
    const auto joined = [&] { return node.is_and ? both(left, right()) : either(left, right()); };
    if (std::optional<Value> merged = value_aside(aside, joined)) return *std::move(merged);
  }
  const auto settled = [&] { return Value(!node.is_and); };
  if (node.is_and) return choose_side(left, node.site, node.left->span, node.assigned, right, settled);
  return choose_side(left, node.site, node.left->span, node.assigned, settled, right);
}

Value Walk::if_expression(const IfExpr& node) {
  const Value condition = tested(*node.condition);
  if (node.computes && shows_both_sides(condition))
    if (std::optional<Value> merged = of_both_sides(condition, node)) return *std::move(merged);
  return choose_side(
      condition, node.site, node.condition->span, node.assigned, [&] { return expression(*node.then_value); },
      [&] { return expression(*node.else_value); });
}

/// The value with which a trace shows both sides. Nothing where one of them does more than to compute, or
/// makes a mistake where it is not taken.
std::optional<Value> Walk::of_both_sides(const Value& condition, const IfExpr& node) {
  Aside aside;
  return value_aside(aside, [&] {
    const Value then_value = expression(*node.then_value);
    const Value else_value = expression(*node.else_value);
    return select(condition, then_value, else_value, node.span);
  });
}

Value Walk::function(const FunctionExpr& node) {
  const bool top_level = current_->function == &program_.top(current_->module);
  return make_ref<Closure>(node.function.get(), top_level ? Ref<Frame>() : current_->frame, current_->module);
}

}  // namespace solitaire
