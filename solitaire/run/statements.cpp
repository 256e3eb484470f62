#include <utility>

#include "solitaire/run/restored.h"
#include "solitaire/run/walk.h"

namespace solitaire {

Value Walk::run(Choices& choices, Effects& effects, std::uint32_t levels) {
  reset(effects, levels);
  choices_ = &choices;
  try {
    return run_module(0);
  } catch (const PathEnd&) {
    return {};
  }
}

Value Walk::run_output(const OutputStmt& output, Effects& effects, Value value) {
  effects_ = &effects;
  choices_ = nullptr;
  const Restored<Branches*> restored(branches_, nullptr);  // whoever looks for paths is told of none here
  return run_at_end(*output.body, std::move(value));
}

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
    case StmtKind::kOutput:
      return true;  // run_output() runs it
    case StmtKind::kAuxiliary: {
      const Restored<bool> restored(auxiliary_, true);
      return statement(*static_cast<const AuxiliaryStmt&>(node).body);
    }
    case StmtKind::kError:
      return true;  // a program with errors is never run
  }
  return true;
}

bool Walk::if_statement(const IfStmt& node) {
  const Value condition = tested(*node.condition);
  if (node.weighs && shows_both_sides(condition) && weigh_both_sides(condition, node)) return true;
  Value unused;
  return branch(
      condition, node.site, node.condition->span, node.assigned, unused,
      [&](Value&) { return statement(*node.then_body); },
      [&](Value&) { return node.else_body == nullptr || statement(*node.else_body); });
}

/// Weighs the execution by the side that is taken, so that a trace shows both of them. Returns false, with
/// nothing done, where one of them makes a mistake.
bool Walk::weigh_both_sides(const Value& condition, const IfStmt& node) {
  Aside then_side, else_side;
  const auto run = [&](Aside& aside, const Stmt& body) {
    return value_aside(aside, [&] { return statement(body), Value::nil(); }).has_value();
  };
  if (!run(then_side, *node.then_body)) return false;
  if (node.else_body != nullptr && !run(else_side, *node.else_body)) return false;
  const Value none = 0.0;
  for (const auto& [span, weight] : then_side.factors())
    effects_->factor(span, select(condition, weight, none, span));
  for (const auto& [span, weight] : else_side.factors())
    effects_->factor(span, select(condition, none, weight, span));
  return true;
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
  leave(current_->returns, current_->region, slots_kept(*current_), std::move(value));
  ++path_.losses.returns;
  return false;
}

bool Walk::jump(const Stmt& node) {
  if (node.kind == StmtKind::kBreak) {
    leave(loop_->breaks, loop_->region, loop_->assigned, {});
    ++path_.losses.breaks;
  } else {
    leave(loop_->continues, loop_->turn_region, loop_->assigned, {});
    ++path_.losses.continues;
  }
  return false;
}

void Walk::param(const ParamStmt& node) {
  const Value usual = expression(*node.value);
  const auto set = params_.find(node.name);
  slot(node.slot) = set == params_.end() ? usual : set->second;
}

}  // namespace solitaire
