#include <fmt/format.h>

#include "solitaire/run/evaluation.h"

namespace solitaire {

/// Every statement says whether the path goes on behind it.
bool Evaluator::statement(const Stmt& node) {
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
      current_->frame->slots[record.slot] = make_ref<RecordType>(&record, current_->module);
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

bool Evaluator::block(const BlockStmt& node) {
  for (const StmtPtr& child : node.statements) {
    if (!statement(*child)) return false;
  }
  return true;
}

bool Evaluator::if_statement(const IfStmt& node) {
  const NodeId holds = condition(expression(*node.condition), node.condition->span);
  Value unused;
  return branch(
      holds, node.site, node.condition->span, node.assigned, unused,
      [&](Value&) { return statement(*node.then_body); },
      [&](Value&) { return node.else_body == nullptr || statement(*node.else_body); });
}

void Evaluator::assignment(const AssignStmt& node) {
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

bool Evaluator::return_statement(const ReturnStmt& node) {
  Value value = Value::nil();
  if (node.values.size() == 1) {
    value = expression(*node.values.front());
  } else if (!node.values.empty()) {
    std::vector<Value> values;
    for (const ExprPtr& each : node.values) values.push_back(expression(*each));
    value = make_list(std::move(values), node.span);
  }
  std::vector<Slot> slots;
  if (symbolic() && current_->function->captured) {
    slots.resize(current_->frame->slots.size());
    for (Slot slot = 0; slot < slots.size(); ++slot) slots[slot] = slot;
  }
  add_exit(current_->returns, path_.guard_since(current_->region), slots, std::move(value));
  ++path_.losses.returns;
  return false;
}

bool Evaluator::jump(const Stmt& node) {
  if (node.kind == StmtKind::kBreak) {
    add_exit(loop_->breaks, path_.guard_since(loop_->region), loop_->assigned, {});
    ++path_.losses.breaks;
  } else {
    add_exit(loop_->continues, path_.guard_since(loop_->turn_region), loop_->assigned, {});
    ++path_.losses.continues;
  }
  return false;
}

void Evaluator::param(const ParamStmt& node) {
  const Value usual = expression(*node.value);
  const auto set = params_.find(node.name);
  current_->frame->slots[node.slot] = set == params_.end() ? usual : set->second;
}

}  // namespace solitaire
