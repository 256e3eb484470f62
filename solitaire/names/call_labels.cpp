#include "solitaire/names/call_labels.h"

#include "solitaire/builtins/builtin.h"

namespace solitaire {
namespace {

/// Returns true for calls of the language that are named after what they are for, as choices are.
bool is_named_after_purpose(const Builtin& builtin) {
  return builtin.is_choice || builtin.name == "map" || builtin.name == "filter";
}

const std::vector<StmtPtr>& statements_of(const Program& program, const NameExpr& name) {
  return program.modules[name.binding.level].tree.top->body->statements;
}

}  // namespace

std::string target_name(const Expr& target, Naming naming) {
  switch (target.kind) {
    case ExprKind::kName:
      return static_cast<const NameExpr&>(target).name;
    case ExprKind::kField: {
      const auto& access = static_cast<const FieldExpr&>(target);
      return naming == Naming::kAfterFunctions ? access.field
                                               : target_name(*access.object) + '.' + access.field;
    }
    case ExprKind::kIndex:
      return target_name(*static_cast<const IndexExpr&>(target).object, naming);
    default:
      return "";
  }
}

std::string call_label(const Program& program, const Expr& callee, const std::string& purpose,
                       Naming naming) {
  if (callee.kind == ExprKind::kField) return static_cast<const FieldExpr&>(callee).field;
  if (callee.kind != ExprKind::kName) return "call";
  const auto& name = static_cast<const NameExpr&>(callee);
  if (purpose.empty()) return name.name;
  const bool builtin =
      name.binding.kind == Binding::Kind::kBuiltin && is_named_after_purpose(builtins()[name.binding.level]);
  const bool library = naming != Naming::kAfterFunctions && is_of_library(program, callee) &&
                       imported_fields(program, name) == nullptr;
  return builtin || library ? purpose : name.name;
}

bool is_of_library(const Program& program, const Expr& callee) {
  if (callee.kind != ExprKind::kName) return false;
  const Binding& binding = static_cast<const NameExpr&>(callee).binding;
  return binding.kind == Binding::Kind::kModule && program.modules[binding.level].is_library;
}

const Function* imported_function(const Program& program, const NameExpr& name) {
  for (const StmtPtr& statement : statements_of(program, name)) {
    if (statement->kind != StmtKind::kAssign) continue;
    const auto& assign = static_cast<const AssignStmt&>(*statement);
    if (assign.declares_function && target_name(*assign.targets.front()) == name.name)
      return static_cast<const FunctionExpr&>(*assign.values.front()).function.get();
  }
  return nullptr;
}

const std::vector<Parameter>* imported_fields(const Program& program, const NameExpr& name) {
  for (const StmtPtr& statement : statements_of(program, name)) {
    if (statement->kind != StmtKind::kRecord) continue;
    const auto& record = static_cast<const RecordStmt&>(*statement);
    if (record.name == name.name) return &record.fields;
  }
  return nullptr;
}

void collect_results(const Expr& returned, std::set<const Expr*>& results) {
  switch (returned.kind) {
    case ExprKind::kCall:
      results.insert(&returned);
      return;
    case ExprKind::kComprehension:
      return collect_results(*static_cast<const ComprehensionExpr&>(returned).element, results);
    case ExprKind::kIf:
      collect_results(*static_cast<const IfExpr&>(returned).then_value, results);
      return collect_results(*static_cast<const IfExpr&>(returned).else_value, results);
    default:
      return;
  }
}

}  // namespace solitaire
