#include "solitaire/syntax/statement_parser.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace solitaire {
namespace {

constexpr std::pair<TokenKind, BinaryOp> kCompoundAssignments[] = {
    {TokenKind::kPlusAssign, BinaryOp::kAdd},       {TokenKind::kMinusAssign, BinaryOp::kSubtract},
    {TokenKind::kStarAssign, BinaryOp::kMultiply},  {TokenKind::kSlashAssign, BinaryOp::kDivide},
    {TokenKind::kPercentAssign, BinaryOp::kModulo},
};

std::optional<BinaryOp> compound_operator(TokenKind sign) {
  for (const auto& [token, op] : kCompoundAssignments) {
    if (token == sign) return op;
  }
  return std::nullopt;
}

/// `area = fun(o) { ... }` gives the function its variable's name.
void name_functions(AssignStmt& node) {
  for (std::size_t i = 0; i < std::min(node.targets.size(), node.values.size()); ++i) {
    if (node.targets[i]->kind != ExprKind::kName || node.values[i]->kind != ExprKind::kFunction) continue;
    static_cast<FunctionExpr&>(*node.values[i]).function->name =
        static_cast<NameExpr&>(*node.targets[i]).name;
  }
}

bool is_function(const std::vector<ExprPtr>& values) {
  return !values.empty() && values.back()->kind == ExprKind::kFunction;
}

}  // namespace

SyntaxTree StatementParser::file() {
  SyntaxTree tree;
  const Span first = peek().span;
  tree.top = std::make_unique<Function>();
  tree.top->body = std::make_unique<BlockStmt>(first);
  while (!at(TokenKind::kEnd)) {
    if (at(TokenKind::kRightBrace)) {
      report("stray-brace", peek().span, "this '}' closes nothing");
      take();
    } else {
      tree.top->body->statements.push_back(recovering_statement());
    }
  }
  tree.top->span = tree.top->body->span = cover(first, peek().span);
  TokenList list = take_tokens();
  tree.tokens = std::move(list.tokens);
  tree.comments = std::move(list.comments);
  tree.skipped_names = take_skipped_names();
  return tree;
}

ExprPtr StatementParser::only_expression() {
  ExprPtr value = expression();
  if (!at(TokenKind::kEnd)) fail(fmt::format("unexpected {}", describe(peek().kind)));
  return value;
}

StmtPtr StatementParser::recovering_statement() {
  const std::size_t outer = begin_statement();
  StmtPtr made = statement();
  end_statement(outer);
  return finish(std::move(made));
}

StmtPtr StatementParser::statement() {
  const Nesting nesting(*this);
  switch (peek().kind) {
    case TokenKind::kLeftBrace:
      return block();
    case TokenKind::kIf:
      return if_statement();
    case TokenKind::kFor:
      return for_statement();
    case TokenKind::kWhile:
      return while_statement();
    case TokenKind::kBreak:
    case TokenKind::kContinue:
      return jump_statement();
    case TokenKind::kReturn:
      return return_statement();
    case TokenKind::kRecord:
      return record_statement();
    case TokenKind::kParam:
      return param_statement();
    case TokenKind::kImport:
      return import_statement();
    case TokenKind::kFun:
      return peek(1).kind == TokenKind::kName ? function_statement() : assignment_or_expression();
    case TokenKind::kElse:
      fail("this 'else' belongs to no 'if'");
      return std::make_unique<ErrorStmt>(peek().span);
    default:
      if (at_word("output", TokenKind::kLeftBrace)) return output_statement();
      if (at_word("aux", TokenKind::kName)) return auxiliary_statement();
      return assignment_or_expression();
  }
}

/// Returns true at a word that is a name elsewhere, and a keyword before such a token.
bool StatementParser::at_word(std::string_view word, TokenKind next) const {
  return at(TokenKind::kName) && peek().text == word && peek(1).kind == next;
}

std::unique_ptr<BlockStmt> StatementParser::block() {
  const Span open = expect(TokenKind::kLeftBrace, "to open a block").span;
  auto node = std::make_unique<BlockStmt>(open);
  while (!panicking() && !at(TokenKind::kRightBrace)) {
    if (at(TokenKind::kEnd)) {
      report("unclosed-bracket", open, "this '{' is never closed");
      break;
    }
    node->statements.push_back(recovering_statement());
  }
  accept(TokenKind::kRightBrace);
  return finish(std::move(node));
}

// ---- branches and loops

StmtPtr StatementParser::if_statement() {
  auto node = std::make_unique<IfStmt>(take().span);
  node->condition = expression();
  accept(TokenKind::kColon);
  if (!accept(TokenKind::kThen) && !at(TokenKind::kLeftBrace)) {
    fail(fmt::format("expected 'then' or '{{' after the condition, found {}", describe(peek().kind)),
         at(TokenKind::kAssign) ? "a comparison for equality is ==" : "");
  }
  node->then_body = body();
  if (accept(TokenKind::kElse)) {
    accept(TokenKind::kColon);
    node->else_body = body();
  }
  return finish(std::move(node));
}

StmtPtr StatementParser::for_statement() {
  auto node = std::make_unique<ForStmt>(take().span);
  node->variables = loop_variables();
  node->list = expression();
  node->body = loop_body();
  return finish(std::move(node));
}

StmtPtr StatementParser::while_statement() {
  auto node = std::make_unique<WhileStmt>(take().span);
  node->condition = expression();
  node->body = loop_body();
  return finish(std::move(node));
}

StmtPtr StatementParser::loop_body() {
  if (!accept(TokenKind::kColon) && !at(TokenKind::kLeftBrace)) {
    fail(fmt::format("expected ':' or '{{' before the loop's body, found {}", describe(peek().kind)),
         at(TokenKind::kAssign) ? "a comparison for equality is ==" : "");
  }
  return body();
}

/// Reads the statement that a head controls, also behind a head that could not be read if a block follows.
StmtPtr StatementParser::body() {
  recover_at_block();
  if (panicking()) return std::make_unique<ErrorStmt>(peek().span);
  return recovering_statement();
}

StmtPtr StatementParser::jump_statement() {
  const StmtKind kind = at(TokenKind::kBreak) ? StmtKind::kBreak : StmtKind::kContinue;
  auto node = std::make_unique<JumpStmt>(kind, take().span);
  semicolon();
  return finish(std::move(node));
}

StmtPtr StatementParser::return_statement() {
  auto node = std::make_unique<ReturnStmt>(take().span);
  if (!at(TokenKind::kSemicolon) && !at(TokenKind::kRightBrace) && !at(TokenKind::kElse) &&
      !at(TokenKind::kEnd)) {
    do node->values.push_back(expression());
    while (accept(TokenKind::kComma));
  }
  semicolon(is_function(node->values));
  return finish(std::move(node));
}

// ---- declarations

StmtPtr StatementParser::record_statement() {
  auto node = std::make_unique<RecordStmt>(take().span);
  const Token& name = expect(TokenKind::kName, "as the record's name");
  node->name = name.text;
  node->name_span = name.span;
  node->fields = parameters();
  semicolon();
  return finish(std::move(node));
}

StmtPtr StatementParser::param_statement() {
  auto node = std::make_unique<ParamStmt>(take().span);
  const Token& name = expect(TokenKind::kName, "as the param's name");
  node->name = name.text;
  node->name_span = name.span;
  expect(TokenKind::kAssign, "after the param's name", "a param has a default: param groups = 3;");
  node->value = expression();
  semicolon();
  return finish(std::move(node));
}

StmtPtr StatementParser::import_statement() {
  auto node = std::make_unique<ImportStmt>(take().span);
  const Token& path = expect(TokenKind::kString, "as the file to import", "write import \"std/layout.sol\";");
  node->is_complete = !panicking();
  node->path = path.text;
  node->path_span = path.span;
  semicolon();
  return finish(std::move(node));
}

StmtPtr StatementParser::output_statement() {
  auto node = std::make_unique<OutputStmt>(take().span);
  node->body = block();
  return finish(std::move(node));
}

StmtPtr StatementParser::auxiliary_statement() {
  auto node = std::make_unique<AuxiliaryStmt>(take().span);
  node->body = assignment_or_expression();
  return finish(std::move(node));
}

StmtPtr StatementParser::function_statement() {
  auto node = std::make_unique<AssignStmt>(peek().span);
  const Span start = take().span;
  const Token& name = take();
  node->declares_function = true;
  node->targets.push_back(std::make_unique<NameExpr>(name.span, name.text));
  node->values.push_back(function_from(start, name.text));
  accept(TokenKind::kSemicolon);
  return finish(std::move(node));
}

// ---- assignments and expressions

StmtPtr StatementParser::assignment_or_expression() {
  Span start = peek().span;
  std::vector<ExprPtr> left;
  do left.push_back(expression());
  while (accept(TokenKind::kComma));
  start.begin = std::min(start.begin, left.front()->span.begin);  // less if the first token is no expression

  const std::optional<BinaryOp> op = compound_operator(peek().kind);
  if (op || at(TokenKind::kAssign)) {
    auto node = std::make_unique<AssignStmt>(start);
    node->op = op;
    return assignment(std::move(node), std::move(left));
  }
  if (left.size() > 1)
    fail(fmt::format("expected '=' after several variables, found {}", describe(peek().kind)));
  auto node = std::make_unique<ExprStmt>(start);
  node->value = std::move(left.front());
  semicolon(node->value->kind == ExprKind::kFunction);
  return finish(std::move(node));
}

StmtPtr StatementParser::assignment(std::unique_ptr<AssignStmt> node, std::vector<ExprPtr> targets) {
  node->op_span = take().span;
  node->targets = std::move(targets);
  do node->values.push_back(expression());
  while (accept(TokenKind::kComma));
  for (const ExprPtr& target : node->targets) check_target(*target);
  check_counts(*node);
  name_functions(*node);
  semicolon(is_function(node->values));
  return finish(std::move(node));
}

void StatementParser::check_target(const Expr& target) {
  const Expr* base = &target;
  while (base->kind == ExprKind::kIndex || base->kind == ExprKind::kField) {
    base = base->kind == ExprKind::kIndex ? static_cast<const IndexExpr*>(base)->object.get()
                                          : static_cast<const FieldExpr*>(base)->object.get();
  }
  if (base->kind == ExprKind::kName || base->kind == ExprKind::kError) return;
  report("not-assignable", target.span, "this cannot be assigned to",
         "what stands left of '=' is a variable, its field or its element");
}

void StatementParser::check_counts(const AssignStmt& node) {
  const std::size_t targets = node.targets.size();
  const std::size_t values = node.values.size();
  if (node.op && (targets != 1 || values != 1)) {
    report("assignment-count", node.op_span, "this changes one variable by one value");
  } else if (targets == 1 && values > 1) {
    report("assignment-count", node.values[1]->span, "one variable, but several values",
           "put the values in brackets for a list: [a, b]");
  } else if (values != 1 && values != targets) {
    report("assignment-count", node.op_span, fmt::format("{} variables, but {} values", targets, values));
  }
}

// ---- the ends of statements

/// Reads the ';' that ends a statement. It may be left out before '}' and 'else', at the end of the file, and
/// after a function's closing '}'.
void StatementParser::semicolon(bool ends_with_function) {
  if (panicking() || accept(TokenKind::kSemicolon)) return;
  if (at(TokenKind::kRightBrace) || at(TokenKind::kElse) || at(TokenKind::kEnd) || ends_with_function) return;
  if (!on_new_line()) {
    std::string help = foreign_keyword_help();
    if (!help.empty()) distrust_name(statement_start());
    if (help.empty()) help = help_for_if();
    if (help.empty() && at(TokenKind::kAssign)) help = "a comparison for equality is ==";
    return fail(fmt::format("expected ';' or an operator, found {}", describe(peek().kind)), help);
  }
  const Span end{previous().span.source, previous().span.end, previous().span.end};
  report("missing-semicolon", end, "expected ';' after this statement");
}

/// Returns true for what 'else if' is called in other languages.
bool StatementParser::is_else_if(const Token& token) {
  return token.kind == TokenKind::kName &&
         (token.text == "elif" || token.text == "elsif" || token.text == "elseif");
}

/// Returns what to write for a keyword of another language that was read as the statement's first name, or
/// stands where the statement should end.
std::string StatementParser::foreign_keyword_help() const {
  if (is_else_if(peek())) return "write 'else if'";
  if (statement_start().kind != TokenKind::kName) return "";
  const std::string& word = statement_start().text;
  if (word == "let" || word == "var" || word == "const") return "a variable is made by assigning it: x = 3;";
  if (word == "def" || word == "function" || word == "func") return "a function is written fun f(x) { ... }";
  if (is_else_if(statement_start())) return "write 'else if'";
  const bool is_first = &previous() == &statement_start();
  if (is_first && (word == "assert" || word == "print"))
    return fmt::format("{0} is a function: {0}(...)", word);
  return "";
}

}  // namespace solitaire
