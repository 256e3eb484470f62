#include "solitaire/names/plain.h"

#include <algorithm>
#include <string_view>

#include "solitaire/builtins/builtin.h"

namespace solitaire {
namespace {

/// Says which builtins an expression may call.
using Allows = bool (*)(std::string_view builtin);

/// Those that compute at once, or state a condition. Those that go through all pairs of a list are not among
/// them.
bool is_plain_builtin(std::string_view name) {
  constexpr std::string_view kNames[] = {"abs",   "all",    "any", "assert", "cond", "contains",
                                         "floor", "length", "max", "min",    "mod",  "sum"};
  return std::ranges::find(kNames, name) != std::end(kNames);
}

/// Those that compute numbers, and distributions as values.
bool is_computing_builtin(std::string_view name) {
  constexpr std::string_view kNames[] = {"cos", "exp", "lgamma", "log", "log_density", "pow", "sin", "sqrt"};
  if (std::ranges::find(kNames, name) != std::end(kNames)) return true;
  const bool makes_distribution = 'A' <= name.front() && name.front() <= 'Z';
  return makes_distribution || (is_plain_builtin(name) && name != "assert");
}

/// The name of the builtin that is called, or "".
std::string_view called_builtin(const CallExpr& node) {
  if (node.callee->kind != ExprKind::kName) return "";
  const Binding& callee = static_cast<const NameExpr&>(*node.callee).binding;
  return callee.kind == Binding::Kind::kBuiltin ? builtins()[callee.level].name : std::string_view();
}

bool is_of(const Expr& node, Allows allows);

bool are_of(const std::vector<Argument>& arguments, Allows allows) {
  return std::ranges::all_of(arguments,
                             [&](const Argument& argument) { return is_of(*argument.value, allows); });
}

bool is_call_of(const CallExpr& node, Allows allows) {
  const std::string_view name = called_builtin(node);
  return !name.empty() && allows(name) && are_of(node.arguments, allows);
}

bool are_plain(const std::vector<ExprPtr>& nodes) {
  return std::ranges::all_of(nodes, [](const ExprPtr& node) { return is_plain(*node); });
}

/// Returns true if the expression evaluates at once, and calls such builtins alone.
bool is_of(const Expr& node, Allows allows) {
  switch (node.kind) {
    case ExprKind::kLiteral:
    case ExprKind::kName:
      return true;
    case ExprKind::kUnary:
      return is_of(*static_cast<const UnaryExpr&>(node).operand, allows);
    case ExprKind::kBinary: {
      const auto& binary = static_cast<const BinaryExpr&>(node);
      return binary.op != BinaryOp::kUpTo && is_of(*binary.left, allows) && is_of(*binary.right, allows);
    }
    case ExprKind::kLogical: {
      const auto& logical = static_cast<const LogicalExpr&>(node);
      return is_of(*logical.left, allows) && is_of(*logical.right, allows);
    }
    case ExprKind::kField:
      return is_of(*static_cast<const FieldExpr&>(node).object, allows);
    case ExprKind::kIndex: {
      const auto& index = static_cast<const IndexExpr&>(node);
      return is_of(*index.object, allows) && is_of(*index.index, allows);
    }
    case ExprKind::kIf: {
      const auto& choice = static_cast<const IfExpr&>(node);
      return is_of(*choice.condition, allows) && is_of(*choice.then_value, allows) &&
             is_of(*choice.else_value, allows);
    }
    case ExprKind::kCall:
      return is_call_of(static_cast<const CallExpr&>(node), allows);
    default:
      return false;
  }
}

}  // namespace

bool is_plain(const Expr& node) { return is_of(node, is_plain_builtin); }

bool computes(const Expr& node) { return is_of(node, is_computing_builtin); }

bool weighs(const Stmt& node) {
  if (node.kind == StmtKind::kBlock) {
    return std::ranges::all_of(static_cast<const BlockStmt&>(node).statements,
                               [](const StmtPtr& child) { return weighs(*child); });
  }
  if (node.kind != StmtKind::kExpr) return false;
  const Expr& value = *static_cast<const ExprStmt&>(node).value;
  if (value.kind != ExprKind::kCall) return false;
  const auto& call = static_cast<const CallExpr&>(value);
  const std::string_view name = called_builtin(call);
  return (name == "observe" || name == "factor") && are_of(call.arguments, is_computing_builtin);
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
