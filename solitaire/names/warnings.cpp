#include "solitaire/names/warnings.h"

#include <fmt/format.h>
#include <map>
#include <string>

#include "solitaire/syntax/tree_walker.h"

namespace solitaire {
namespace {

/// Returns true if control leaves the statement's block by every path through the statement.
bool leaves(const Stmt& node) {
  switch (node.kind) {
    case StmtKind::kReturn:
    case StmtKind::kBreak:
    case StmtKind::kContinue:
      return true;
    case StmtKind::kIf: {
      const auto& branch = static_cast<const IfStmt&>(node);
      return branch.else_body && leaves(*branch.then_body) && leaves(*branch.else_body);
    }
    case StmtKind::kBlock: {
      const auto& statements = static_cast<const BlockStmt&>(node).statements;
      return !statements.empty() && leaves(*statements.back());
    }
    default:
      return false;
  }
}

/// Returns the name of the function or record that a statement declares, with its place; null if it declares
/// none.
const NameExpr* declared_function(const Stmt& node) {
  if (node.kind != StmtKind::kAssign) return nullptr;
  const auto& assign = static_cast<const AssignStmt&>(node);
  return assign.declares_function ? static_cast<const NameExpr*>(assign.targets.front().get()) : nullptr;
}

class Warnings : public TreeWalker {
 public:
  explicit Warnings(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void statement(const Stmt& node) override {
    if (node.kind == StmtKind::kBlock) {
      const auto& block = static_cast<const BlockStmt&>(node);
      look_for_unreached(block);
      look_for_replaced(block);
    }
    if (node.kind == StmtKind::kExpr) look_for_unused(*static_cast<const ExprStmt&>(node).value);
    TreeWalker::statement(node);
  }

  void expression(const Expr& node) override {
    if (node.kind == ExprKind::kIndex) look_for_negative(*static_cast<const IndexExpr&>(node).index);
    TreeWalker::expression(node);
  }

 private:
  void look_for_negative(const Expr& index) {
    if (index.kind != ExprKind::kUnary) return;
    const auto& negated = static_cast<const UnaryExpr&>(index);
    if (negated.op != UnaryOp::kNegate || negated.operand->kind != ExprKind::kLiteral) return;
    diagnostics_.add({index.span,
                      "no list has such an element: they count from 0",
                      "last(xs) is the last one, and xs[length(xs) - 2] the one before it",
                      {},
                      Severity::kWarning,
                      "negative-index",
                      {}});
  }

  void look_for_unreached(const BlockStmt& block) {
    for (std::size_t i = 1; i < block.statements.size(); ++i) {
      const Stmt& before = *block.statements[i - 1];
      const Stmt& node = *block.statements[i];
      if (!leaves(before) || node.kind == StmtKind::kError || node.kind == StmtKind::kOutput) continue;
      return warn("unreachable", node.span, "this is never reached",
                  {before.span, "control does not come past this"});
    }
  }

  /// An operation only gives its value, but a division may also rule an execution out.
  void look_for_unused(const Expr& value) {
    if (value.kind != ExprKind::kBinary) return;
    const BinaryOp op = static_cast<const BinaryExpr&>(value).op;
    if (op == BinaryOp::kDivide || op == BinaryOp::kModulo) return;
    diagnostics_.add({value.span,
                      "this value is not used",
                      "a function gives what it returns, and what must hold is asserted",
                      {},
                      Severity::kWarning,
                      "unused-value",
                      {}});
  }

  /// Records that replace each other are errors, which the resolver reports.
  void look_for_replaced(const BlockStmt& block) {
    std::map<std::string, Span> functions, records;
    for (const StmtPtr& statement : block.statements) {
      if (const NameExpr* name = declared_function(*statement)) {
        look_for_replaced(records, name->name, name->span);
        look_for_replaced(functions, name->name, name->span);
        functions.try_emplace(name->name, name->span);
      } else if (statement->kind == StmtKind::kRecord) {
        const auto& record = static_cast<const RecordStmt&>(*statement);
        look_for_replaced(functions, record.name, record.name_span);
        records.try_emplace(record.name, record.name_span);
      }
    }
  }

  void look_for_replaced(const std::map<std::string, Span>& declared, const std::string& name, Span place) {
    const auto it = declared.find(name);
    if (it == declared.end() || name.empty()) return;
    warn("replaced-definition", place, fmt::format("'{}' is defined here a second time", name),
         {it->second, "the definition that it replaces is here"});
  }

  void warn(const std::string& code, Span span, std::string message, RelatedPlace related) {
    diagnostics_.add({span, std::move(message), "", {}, Severity::kWarning, code, {std::move(related)}});
  }

  Diagnostics& diagnostics_;
};

}  // namespace

void add_warnings(const SyntaxTree& tree, Diagnostics& diagnostics) {
  Warnings(diagnostics).function(*tree.top);
}

}  // namespace solitaire
