#include "solitaire/names/plain.h"

#include <algorithm>
#include <string_view>

#include "solitaire/builtins/builtin.h"

namespace solitaire {
namespace {

/// Builtins that compute at once, or state a condition. Those that go through all pairs of a list are not
/// among them.
constexpr std::string_view kPlainBuiltins[] = {"abs",   "all",    "any", "assert", "cond", "contains",
                                               "floor", "length", "max", "min",    "mod",  "sum"};

bool is_plain_call(const CallExpr& node) {
  if (node.callee->kind != ExprKind::kName) return false;
  const Binding& callee = static_cast<const NameExpr&>(*node.callee).binding;
  return callee.kind == Binding::Kind::kBuiltin &&
         std::ranges::find(kPlainBuiltins, builtins()[callee.level].name) != std::end(kPlainBuiltins) &&
         std::ranges::all_of(node.arguments,
                             [](const Argument& argument) { return is_plain(*argument.value); });
}

bool are_plain(const std::vector<ExprPtr>& nodes) {
  return std::ranges::all_of(nodes, [](const ExprPtr& node) { return is_plain(*node); });
}

}  // namespace

bool is_plain(const Expr& node) {
  switch (node.kind) {
    case ExprKind::kLiteral:
    case ExprKind::kName:
      return true;
    case ExprKind::kUnary:
      return is_plain(*static_cast<const UnaryExpr&>(node).operand);
    case ExprKind::kBinary: {
      const auto& binary = static_cast<const BinaryExpr&>(node);
      return binary.op != BinaryOp::kUpTo && is_plain(*binary.left) && is_plain(*binary.right);
    }
    case ExprKind::kLogical: {
      const auto& logical = static_cast<const LogicalExpr&>(node);
      return is_plain(*logical.left) && is_plain(*logical.right);
    }
    case ExprKind::kField:
      return is_plain(*static_cast<const FieldExpr&>(node).object);
    case ExprKind::kIndex: {
      const auto& index = static_cast<const IndexExpr&>(node);
      return is_plain(*index.object) && is_plain(*index.index);
    }
    case ExprKind::kIf: {
      const auto& choice = static_cast<const IfExpr&>(node);
      return is_plain(*choice.condition) && is_plain(*choice.then_value) && is_plain(*choice.else_value);
    }
    case ExprKind::kCall:
      return is_plain_call(static_cast<const CallExpr&>(node));
    default:
      return false;
  }
}

bool is_plain(const Stmt& node) {
  switch (node.kind) {
    case StmtKind::kExpr:
      return is_plain(*static_cast<const ExprStmt&>(node).value);
    case StmtKind::kAssign: {
      const auto& assignment = static_cast<const AssignStmt&>(node);
      return are_plain(assignment.targets) && are_plain(assignment.values);
    }
    case StmtKind::kIf: {
      const auto& branch = static_cast<const IfStmt&>(node);
      return is_plain(*branch.condition) && is_plain(*branch.then_body) &&
             (branch.else_body == nullptr || is_plain(*branch.else_body));
    }
    case StmtKind::kBlock:
      return std::ranges::all_of(static_cast<const BlockStmt&>(node).statements,
                                 [](const StmtPtr& child) { return is_plain(*child); });
    default:
      return false;
  }
}

}  // namespace solitaire
