#include <fmt/format.h>

#include "solitaire/run/walk.h"

namespace solitaire {

/// Every statement returns whether the path goes on behind it.
bool Walk::statement(const Stmt& node) {
  step(node.span);
  switch (node.kind) {
    case StmtKind::kAssign:
      assignment(static_cast<const AssignStmt&>(node));
      return true;
    case StmtKind::kExpr:
      expression(*static_cast<const ExprStmt&>(node).value);
      return true;
    case StmtKind::kIf:
      return if_statement(static_cast<const IfStmt&>(node));
    case StmtKind::kFor:
      return for_statement(static_cast<const ForStmt&>(node));
    case StmtKind::kWhile:
      return while_statement(static_cast<const WhileStmt&>(node));
    case StmtKind::kBreak:
    case StmtKind::kContinue:
      return jump(node);
    case StmtKind::kReturn:
      return return_statement(static_cast<const ReturnStmt&>(node));
    case StmtKind::kBlock:
      return block(static_cast<const BlockStmt&>(node));
    case StmtKind::kParam:
      param(static_cast<const ParamStmt&>(node));
      return true;
    case StmtKind::kRecord: {
      const auto& record = static_cast<const RecordStmt&>(node);
      slot(record.slot) = make_ref<RecordType>(&record, current_->module);
      return true;
    }
    case StmtKind::kImport: {
      const std::uint32_t module = static_cast<const ImportStmt&>(node).module;
      if (!module_done_[module]) run_module(module);
      return true;
    }
    case StmtKind::kError:
      return true;  // a program with errors is never run
  }
  return true;
}

bool Walk::block(const BlockStmt& node) {
  for (const StmtPtr& child : node.statements) {
    if (!statement(*child)) return false;
  }
  return true;
}

bool Walk::if_statement(const IfStmt& node) {
  Value unused;
  return branch(
      tested(*node.condition), node.site, node.condition->span, node.assigned, unused,
      [&](Value&) { return statement(*node.then_body); },
      [&](Value&) { return node.else_body == nullptr || statement(*node.else_body); });
}

void Walk::assignment(const AssignStmt& node) {
  if (node.op) {
    const Expr& target = *node.targets.front();
    const Value amount = expression(*node.values.front());
    const Span span = cover(target.span, node.values.front()->span);
    if (target.kind == ExprKind::kName)
      return assign(target, arithmetic(*node.op, expression(target), amount, span));
    return change(target, [&](Value& place) { place = arithmetic(*node.op, place, amount, span); });
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

bool Walk::return_statement(const ReturnStmt& node) {
  Value value = Value::nil();
  if (node.values.size() == 1) {
    value = expression(*node.values.front());
  } else if (!node.values.empty()) {
    std::vector<Value> values;
    for (const ExprPtr& each : node.values) values.push_back(expression(*each));
    value = make_list(std::move(values), node.span);
  }
  if (current_->call == nullptr) count_parts(value, node.span);  // all of a solution's value is written
  add_exit(current_->returns, path_.guard_since(current_->region), slots_kept(*current_), std::move(value));
  ++path_.losses.returns;
  return false;
}

bool Walk::jump(const Stmt& node) {
  if (node.kind == StmtKind::kBreak) {
    add_exit(loop_->breaks, path_.guard_since(loop_->region), loop_->assigned, {});
    ++path_.losses.breaks;
  } else {
    add_exit(loop_->continues, path_.guard_since(loop_->turn_region), loop_->assigned, {});
    ++path_.losses.continues;
  }
  return false;
}

void Walk::param(const ParamStmt& node) {
  const Value usual = expression(*node.value);
  const auto set = params_.find(node.name);
  slot(node.slot) = set == params_.end() ? usual : set->second;
}

// ---- what an assignment changes

void Walk::assign(const Expr& target, Value value) {
  if (target.kind == ExprKind::kName) {
    slot(static_cast<const NameExpr&>(target).binding.slot) = std::move(value);
    return;
  }
  change(target, [&](Value& place) { place = value; });
}

/// Evaluates the target's indices, once, and changes what it stands for.
void Walk::change(const Expr& target, const Change& change) {
  std::vector<Value> indices;  // evaluated before anything changes, innermost last
  for (const Expr* at = &target; at->kind != ExprKind::kName;) {
    if (at->kind == ExprKind::kIndex) {
      const auto& index = static_cast<const IndexExpr&>(*at);
      indices.insert(indices.begin(), expression(*index.index));
      at = index.object.get();
    } else {
      at = static_cast<const FieldExpr&>(*at).object.get();
    }
  }
  update(target, indices, change);
}

/// Changes what the target stands for in place: the variable's value is only copied where others share it.
void Walk::update(const Expr& target, std::span<const Value> indices, const Change& change) {
  if (target.kind == ExprKind::kName) {
    const auto& name = static_cast<const NameExpr&>(target);
    Value& variable = slot(name.binding.slot);
    if (variable.is<Value::Unset>() || variable.as_union() != nullptr)
      variable = read(frame(), name.binding.slot, name);
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
