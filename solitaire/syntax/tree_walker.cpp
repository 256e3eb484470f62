#include "solitaire/syntax/tree_walker.h"

namespace solitaire {

void TreeWalker::function(const Function& node) {
  for (const Parameter& parameter : node.parameters) {
    if (parameter.default_value) expression(*parameter.default_value);
  }
  statement(*node.body);
}

void TreeWalker::expression(const Expr& node) {
  switch (node.kind) {
    case ExprKind::kLiteral:
    case ExprKind::kName:
    case ExprKind::kError:
      return;
    case ExprKind::kList:
      for (const ExprPtr& item : static_cast<const ListExpr&>(node).items) expression(*item);
      return;
    case ExprKind::kUnary:
      return expression(*static_cast<const UnaryExpr&>(node).operand);
    case ExprKind::kBinary:
      expression(*static_cast<const BinaryExpr&>(node).left);
      return expression(*static_cast<const BinaryExpr&>(node).right);
    case ExprKind::kLogical:
      expression(*static_cast<const LogicalExpr&>(node).left);
      return expression(*static_cast<const LogicalExpr&>(node).right);
    case ExprKind::kCall:
      expression(*static_cast<const CallExpr&>(node).callee);
      for (const Argument& argument : static_cast<const CallExpr&>(node).arguments)
        expression(*argument.value);
      return;
    case ExprKind::kIndex:
      expression(*static_cast<const IndexExpr&>(node).object);
      return expression(*static_cast<const IndexExpr&>(node).index);
    case ExprKind::kField:
      return expression(*static_cast<const FieldExpr&>(node).object);
    case ExprKind::kIf:
      expression(*static_cast<const IfExpr&>(node).condition);
      expression(*static_cast<const IfExpr&>(node).then_value);
      return expression(*static_cast<const IfExpr&>(node).else_value);
    case ExprKind::kFunction:
      return function(*static_cast<const FunctionExpr&>(node).function);
    case ExprKind::kComprehension:
      return comprehension(static_cast<const ComprehensionExpr&>(node));
  }
}

void TreeWalker::comprehension(const ComprehensionExpr& node) {
  expression(*node.element);
  for (const ComprehensionClause& clause : node.clauses) {
    expression(*clause.list);
    for (const ExprPtr& condition : clause.conditions) expression(*condition);
  }
}

void TreeWalker::statement(const Stmt& node) {
  switch (node.kind) {
    case StmtKind::kAssign:
      for (const ExprPtr& target : static_cast<const AssignStmt&>(node).targets) expression(*target);
      for (const ExprPtr& value : static_cast<const AssignStmt&>(node).values) expression(*value);
      return;
    case StmtKind::kExpr:
      return expression(*static_cast<const ExprStmt&>(node).value);
    case StmtKind::kIf: {
      const auto& branch = static_cast<const IfStmt&>(node);
      expression(*branch.condition);
      statement(*branch.then_body);
      if (branch.else_body) statement(*branch.else_body);
      return;
    }
    case StmtKind::kFor:
      expression(*static_cast<const ForStmt&>(node).list);
      return statement(*static_cast<const ForStmt&>(node).body);
    case StmtKind::kWhile:
      expression(*static_cast<const WhileStmt&>(node).condition);
      return statement(*static_cast<const WhileStmt&>(node).body);
    case StmtKind::kReturn:
      for (const ExprPtr& value : static_cast<const ReturnStmt&>(node).values) expression(*value);
      return;
    case StmtKind::kBlock:
      for (const StmtPtr& child : static_cast<const BlockStmt&>(node).statements) statement(*child);
      return;
    case StmtKind::kRecord:
      for (const Parameter& field : static_cast<const RecordStmt&>(node).fields) {
        if (field.default_value) expression(*field.default_value);
      }
      return;
    case StmtKind::kParam:
      return expression(*static_cast<const ParamStmt&>(node).value);
    case StmtKind::kOutput:
      return statement(*static_cast<const OutputStmt&>(node).body);
    case StmtKind::kAuxiliary:
      return statement(*static_cast<const AuxiliaryStmt&>(node).body);
    case StmtKind::kBreak:
    case StmtKind::kContinue:
    case StmtKind::kImport:
    case StmtKind::kError:
      return;
  }
}

}  // namespace solitaire
