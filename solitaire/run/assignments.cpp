#include "solitaire/run/assignments.h"

namespace solitaire {

void Assignments::assignment(const AssignStmt& node) {
  if (node.op) {
    const Expr& target = *node.targets.front();
    const Value amount = expression(*node.values.front());
    const Span span = cover(target.span, node.values.front()->span);
    if (target.kind == ExprKind::kName)
      return assign(target, operate(*node.op, expression(target), amount, span));
    return change(target, [&](Value& place) { place = operate(*node.op, place, amount, span); });
  }
  if (node.targets.size() == 1) return assign(*node.targets.front(), expression(*node.values.front()));
  if (node.values.size() == 1) {
    const Value value = expression(*node.values.front());
    return take_apart(value, node.targets.size(), node.values.front()->span,
                      [&](std::size_t i, Value part) { assign(*node.targets[i], std::move(part)); });
  }
  std::vector<Value> values;  // all of them first, so that a, b = b, a swaps
  for (const ExprPtr& value : node.values) values.push_back(expression(*value));
  for (std::size_t i = 0; i < values.size(); ++i) assign(*node.targets[i], std::move(values[i]));
}

// ---- what an assignment changes

void Assignments::assign(const Expr& target, Value value) {
  if (target.kind == ExprKind::kName) {
    slot(static_cast<const NameExpr&>(target).binding.slot) = std::move(value);
    return;
  }
  change(target, [&](Value& place) { place = value; });
}

/// Evaluates the target's indices, once, and changes what it stands for.
void Assignments::change(const Expr& target, const Change& change) {
  std::vector<Value> indices;
  evaluate_indices(target, indices);  // before anything changes
  update(target, indices, change);
}

/// The indices of a target from left to right.
void Assignments::evaluate_indices(const Expr& target, std::vector<Value>& indices) {
  if (target.kind == ExprKind::kField)
    return evaluate_indices(*static_cast<const FieldExpr&>(target).object, indices);
  if (target.kind != ExprKind::kIndex) return;
  const auto& access = static_cast<const IndexExpr&>(target);
  evaluate_indices(*access.object, indices);
  indices.push_back(expression(*access.index));
}

/// Changes what the target stands for in place: the variable's value is only copied where others share it.
void Assignments::update(const Expr& target, std::span<const Value> indices, const Change& change) {
  if (target.kind == ExprKind::kName) {
    const auto& name = static_cast<const NameExpr&>(target);
    Value& variable = slot(name.binding.slot);
    if (variable.is<Value::Unset>() || variable.as_union() != nullptr) variable = read(variable, name);
    return change(variable);
  }
  if (target.kind == ExprKind::kIndex) {
    return update(*static_cast<const IndexExpr&>(target).object, indices.first(indices.size() - 1),
                  [&](Value& object) { update_element(object, indices.back(), target.span, change); });
  }
  const auto& access = static_cast<const FieldExpr&>(target);
  update(*access.object, indices, [&](Value& object) { update_field(object, access, change); });
}

}  // namespace solitaire
