#include "solitaire/names/plain_expression.h"

namespace solitaire {

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
    default:
      return false;
  }
}

}  // namespace solitaire
