#include "tests/language/tree_check.h"

namespace solitaire {
namespace {

class TreeCheck {
 public:
  explicit TreeCheck(const SourceSet& sources) : sources_(sources) {}

  std::string fault;
  bool has_error = false;

  void function(const Function& node, Span around) {
    within(node.span, around);
    parameters(node.parameters, node.span);
    statement(node.body.get(), node.span);
  }

 private:
  void within(Span span, Span around) {
    const bool ordered = span.begin <= span.end && span.end <= sources_[0].text().size() && span.source == 0;
    if (!fault.empty() || (ordered && around.begin <= span.begin && span.end <= around.end)) return;
    fault = "the span " + std::to_string(span.begin) + "-" + std::to_string(span.end) + " lies outside of " +
            std::to_string(around.begin) + "-" + std::to_string(around.end);
    if (ordered) fault += ": " + std::string(sources_.text(span));
  }

  void parameters(const std::vector<Parameter>& parameters, Span around) {
    for (const Parameter& parameter : parameters) {
      within(parameter.span, around);
      if (parameter.default_value) expression(parameter.default_value.get(), around);
    }
  }

  template <class Nodes>
  void expressions(const Nodes& nodes, Span around) {
    for (const auto& node : nodes) expression(node.get(), around);
  }

  void expression(const Expr* node, Span around) {
    if (node == nullptr) {
      if (fault.empty()) fault = "an expression is missing";
      return;
    }
    within(node->span, around);
    const Span span = node->span;
    switch (node->kind) {
      case ExprKind::kLiteral:
      case ExprKind::kName:
        return;
      case ExprKind::kError:
        has_error = true;
        return;
      case ExprKind::kList:
        return expressions(static_cast<const ListExpr&>(*node).items, span);
      case ExprKind::kUnary:
        return expression(static_cast<const UnaryExpr&>(*node).operand.get(), span);
      case ExprKind::kBinary:
        return operands(static_cast<const BinaryExpr&>(*node));
      case ExprKind::kLogical:
        return operands(static_cast<const LogicalExpr&>(*node));
      case ExprKind::kCall: {
        const auto& call = static_cast<const CallExpr&>(*node);
        expression(call.callee.get(), span);
        for (const Argument& argument : call.arguments) expression(argument.value.get(), span);
        return;
      }
      case ExprKind::kIndex: {
        const auto& index = static_cast<const IndexExpr&>(*node);
        expression(index.object.get(), span);
        return expression(index.index.get(), span);
      }
      case ExprKind::kField: {
        const auto& field = static_cast<const FieldExpr&>(*node);
        within(field.field_span, span);
        return expression(field.object.get(), span);
      }
      case ExprKind::kIf: {
        const auto& branch = static_cast<const IfExpr&>(*node);
        expression(branch.condition.get(), span);
        expression(branch.then_value.get(), span);
        return expression(branch.else_value.get(), span);
      }
      case ExprKind::kFunction:
        return function(*static_cast<const FunctionExpr&>(*node).function, span);
      case ExprKind::kComprehension: {
        const auto& made = static_cast<const ComprehensionExpr&>(*node);
        expression(made.element.get(), span);
        for (const ComprehensionClause& clause : made.clauses) {
          within(clause.span, span);
          expression(clause.list.get(), span);
          expressions(clause.conditions, span);
        }
      }
    }
  }

  template <class Node>
  void operands(const Node& node) {
    within(node.op_span, node.span);
    expression(node.left.get(), node.span);
    expression(node.right.get(), node.span);
  }

  void statement(const Stmt* node, Span around) {
    if (node == nullptr) {
      if (fault.empty()) fault = "a statement is missing";
      return;
    }
    within(node->span, around);
    const Span span = node->span;
    switch (node->kind) {
      case StmtKind::kAssign: {
        const auto& assign = static_cast<const AssignStmt&>(*node);
        expressions(assign.targets, span);
        return expressions(assign.values, span);
      }
      case StmtKind::kExpr:
        return expression(static_cast<const ExprStmt&>(*node).value.get(), span);
      case StmtKind::kIf: {
        const auto& branch = static_cast<const IfStmt&>(*node);
        expression(branch.condition.get(), span);
        statement(branch.then_body.get(), span);
        if (branch.else_body) statement(branch.else_body.get(), span);
        return;
      }
      case StmtKind::kFor: {
        const auto& loop = static_cast<const ForStmt&>(*node);
        for (const LoopVariable& variable : loop.variables) within(variable.span, span);
        expression(loop.list.get(), span);
        return statement(loop.body.get(), span);
      }
      case StmtKind::kWhile: {
        const auto& loop = static_cast<const WhileStmt&>(*node);
        expression(loop.condition.get(), span);
        return statement(loop.body.get(), span);
      }
      case StmtKind::kReturn:
        return expressions(static_cast<const ReturnStmt&>(*node).values, span);
      case StmtKind::kBlock:
        for (const StmtPtr& child : static_cast<const BlockStmt&>(*node).statements)
          statement(child.get(), span);
        return;
      case StmtKind::kRecord:
        within(static_cast<const RecordStmt&>(*node).name_span, span);
        return parameters(static_cast<const RecordStmt&>(*node).fields, span);
      case StmtKind::kParam:
        within(static_cast<const ParamStmt&>(*node).name_span, span);
        return expression(static_cast<const ParamStmt&>(*node).value.get(), span);
      case StmtKind::kImport:
        return within(static_cast<const ImportStmt&>(*node).path_span, span);
      case StmtKind::kOutput:
        return statement(static_cast<const OutputStmt&>(*node).body.get(), span);
      case StmtKind::kAuxiliary:
        return statement(static_cast<const AuxiliaryStmt&>(*node).body.get(), span);
      case StmtKind::kError:
        has_error = true;
        return;
      case StmtKind::kBreak:
      case StmtKind::kContinue:
        return;
    }
  }

  const SourceSet& sources_;
};

}  // namespace

std::string tree_fault(const std::string& text) {
  SourceSet sources;
  sources.add("text.sol", text);
  Diagnostics diagnostics;
  const SyntaxTree tree = parse(sources, 0, diagnostics);
  if (!tree.top || !tree.top->body) return "no tree";
  TreeCheck check(sources);
  const Span whole{0, 0, static_cast<std::uint32_t>(text.size())};
  check.function(*tree.top, whole);
  for (const Diagnostic& diagnostic : diagnostics.list()) {
    if (diagnostic.span.begin > diagnostic.span.end || diagnostic.span.end > text.size())
      return "a message's span";
    format(diagnostic, sources);
  }
  if (check.fault.empty() && check.has_error && diagnostics.empty()) return "an error that is not reported";
  return check.fault;
}

}  // namespace solitaire
