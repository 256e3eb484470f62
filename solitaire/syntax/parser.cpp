#include "solitaire/syntax/parser.h"

#include <algorithm>
#include <fmt/format.h>

#include "solitaire/syntax/lexer.h"

namespace solitaire {
namespace {

/// How deep statements and expressions may nest in the source.
constexpr int kDeepestNesting = 256;
/// How many operators may stand in one chain such as a + b + c: the tree of a chain is as high as it is long.
constexpr int kHighestTree = 1000;

/// Thrown where nothing sensible can follow; caught where the next statement starts.
struct Unreadable {};

struct BinaryLevel {
  TokenKind token;
  int binding;  // higher binds tighter
  BinaryOp op;
};

constexpr int kOrBinding = 1;
constexpr int kAndBinding = 2;
constexpr int kComparisonBinding = 4;

constexpr BinaryLevel kBinary[] = {
    {TokenKind::kEqual, kComparisonBinding, BinaryOp::kEqual},
    {TokenKind::kNotEqual, kComparisonBinding, BinaryOp::kNotEqual},
    {TokenKind::kLess, kComparisonBinding, BinaryOp::kLess},
    {TokenKind::kLessEqual, kComparisonBinding, BinaryOp::kLessEqual},
    {TokenKind::kGreater, kComparisonBinding, BinaryOp::kGreater},
    {TokenKind::kGreaterEqual, kComparisonBinding, BinaryOp::kGreaterEqual},
    {TokenKind::kDotDot, 5, BinaryOp::kUpTo},
    {TokenKind::kPlus, 6, BinaryOp::kAdd},
    {TokenKind::kMinus, 6, BinaryOp::kSubtract},
    {TokenKind::kStar, 7, BinaryOp::kMultiply},
    {TokenKind::kSlash, 7, BinaryOp::kDivide},
    {TokenKind::kPercent, 7, BinaryOp::kModulo},
};

constexpr std::pair<TokenKind, BinaryOp> kCompoundAssignments[] = {
    {TokenKind::kPlusAssign, BinaryOp::kAdd},       {TokenKind::kMinusAssign, BinaryOp::kSubtract},
    {TokenKind::kStarAssign, BinaryOp::kMultiply},  {TokenKind::kSlashAssign, BinaryOp::kDivide},
    {TokenKind::kPercentAssign, BinaryOp::kModulo},
};

const BinaryLevel* binary_level(TokenKind token) {
  const auto* level = std::find_if(std::begin(kBinary), std::end(kBinary),
                                   [&](const BinaryLevel& candidate) { return candidate.token == token; });
  return level == std::end(kBinary) ? nullptr : level;
}

class Parser {
 public:
  Parser(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics)
      : diagnostics_(diagnostics), list_(tokenize(sources, source, diagnostics)), sources_(sources) {}

  SyntaxTree parse_file() {
    SyntaxTree tree;
    tree.top = std::make_unique<Function>();
    tree.top->body = std::make_unique<BlockStmt>(peek().span);
    while (!at(TokenKind::kEnd)) {
      tree.top->body->statements.push_back(recovering_statement());
      if (at(TokenKind::kRightBrace)) report_stray_brace();
    }
    tree.top->span = tree.top->body->span = cover(list_.tokens.front().span, peek().span);
    tree.comments = std::move(list_.comments);
    return tree;
  }

  ExprPtr parse_whole_expression() {
    try {
      ExprPtr value = expression();
      if (!at(TokenKind::kEnd)) fail(fmt::format("unexpected {}", describe(peek().kind)));
      return value;
    } catch (const Unreadable&) {
      return std::make_unique<ErrorExpr>(peek().span);
    }
  }

 private:
  /// Counts nesting while it lives.
  class Nesting {
   public:
    explicit Nesting(Parser& parser) : parser_(parser) {
      if (++parser_.nesting_ > kDeepestNesting) {
        --parser_.nesting_;
        parser_.fail("this nests too deeply", "move an inner part into a function of its own");
      }
    }
    ~Nesting() { --parser_.nesting_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    Parser& parser_;
  };

  // ---- tokens

  const Token& peek(std::size_t ahead = 0) const {
    return list_.tokens[std::min(at_ + ahead, list_.tokens.size() - 1)];
  }
  const Token& previous() const { return list_.tokens[at_ - 1]; }
  bool at(TokenKind kind) const { return peek().kind == kind; }

  const Token& take() {
    const Token& token = peek();
    if (at_ + 1 < list_.tokens.size()) ++at_;
    return token;
  }

  bool accept(TokenKind kind) {
    if (!at(kind)) return false;
    take();
    return true;
  }

  const Token& expect(TokenKind kind, const std::string& where, const std::string& help = "") {
    if (!at(kind))
      fail(fmt::format("expected {} {}, found {}", describe(kind), where, describe(peek().kind)), help);
    return take();
  }

  [[noreturn]] void fail(const std::string& message, const std::string& help = "") {
    diagnostics_.add(peek().span, message, help);
    throw Unreadable{};
  }

  // ---- recovery

  StmtPtr recovering_statement() {
    const std::size_t start = at_;
    const int nesting = nesting_;
    try {
      return statement();
    } catch (const Unreadable&) {
      nesting_ = nesting;
      skip_to_next_statement(start);
      return std::make_unique<ErrorStmt>(cover(list_.tokens[start].span, previous_or_first(start)));
    }
  }

  Span previous_or_first(std::size_t start) const { return list_.tokens[at_ > start ? at_ - 1 : start].span; }

  /// Skips to behind the next ';' or to where a '}' or a statement's keyword stands, over whole brace pairs;
  /// always goes on by a token.
  void skip_to_next_statement(std::size_t start) {
    int open = 0;
    for (; !at(TokenKind::kEnd); take()) {
      if (at(TokenKind::kLeftBrace)) ++open;
      if (at(TokenKind::kRightBrace) && --open < 0) break;
      if (open > 0) continue;
      if (at_ > start && starts_statement(peek().kind)) return;
      if (at(TokenKind::kSemicolon) || (at(TokenKind::kRightBrace) && open == 0)) {
        take();
        return;
      }
    }
  }

  static bool starts_statement(TokenKind kind) {
    switch (kind) {
      case TokenKind::kBreak:
      case TokenKind::kContinue:
      case TokenKind::kFor:
      case TokenKind::kImport:
      case TokenKind::kParam:
      case TokenKind::kRecord:
      case TokenKind::kReturn:
      case TokenKind::kWhile:
        return true;
      default:
        return false;
    }
  }

  void report_stray_brace() {
    diagnostics_.add(peek().span, "this '}' closes nothing");
    take();
  }

  // ---- statements

  StmtPtr statement() {
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
      case TokenKind::kElse:
        fail("this 'else' belongs to no 'if'");
      case TokenKind::kFun:
        if (peek(1).kind == TokenKind::kName) return function_statement();
        return assignment_or_expression();
      default:
        return assignment_or_expression();
    }
  }

  template <class Node>
  std::unique_ptr<Node> finish(std::unique_ptr<Node> node) {
    node->span = cover(node->span, previous().span);
    return node;
  }

  /// A ';' ends a statement; it may be left out before '}' and 'else', at the end of the file, and after a
  /// function's closing '}'.
  void end_statement(bool ends_with_function = false) {
    if (accept(TokenKind::kSemicolon)) return;
    if (at(TokenKind::kRightBrace) || at(TokenKind::kElse) || at(TokenKind::kEnd) || ends_with_function)
      return;
    const Span end{previous().span.source, previous().span.end, previous().span.end};
    if (on_new_line()) {
      diagnostics_.add(end, "expected ';' after this statement");
      return;  // what follows reads as a statement of its own
    }
    fail(fmt::format("expected ';' or an operator, found {}", describe(peek().kind)), foreign_keyword_help());
  }

  /// What to write for a keyword of another language that was read as a name.
  std::string foreign_keyword_help() const {
    if (previous().kind != TokenKind::kName || !at(TokenKind::kName)) return "";
    const std::string& word = previous().text;
    if (word == "let" || word == "var" || word == "const")
      return "a variable is made by assigning it: x = 3;";
    if (word == "def" || word == "function" || word == "func")
      return "a function is written fun f(x) { ... }";
    return "";
  }

  bool on_new_line() const {
    const Source& source = sources_[peek().span.source];
    return source.position(previous().span.end).line < source.position(peek().span.begin).line;
  }

  std::unique_ptr<BlockStmt> block() {
    auto node = std::make_unique<BlockStmt>(peek().span);
    const Token open = expect(TokenKind::kLeftBrace, "to open a block");
    while (!at(TokenKind::kRightBrace)) {
      if (at(TokenKind::kEnd)) {
        diagnostics_.add(open.span, "this '{' is never closed");
        break;
      }
      node->statements.push_back(recovering_statement());
    }
    accept(TokenKind::kRightBrace);
    return finish(std::move(node));
  }

  StmtPtr if_statement() {
    auto node = std::make_unique<IfStmt>(take().span);
    node->condition = expression();
    accept(TokenKind::kColon);
    if (!accept(TokenKind::kThen) && !at(TokenKind::kLeftBrace)) {
      fail(fmt::format("expected 'then' or '{{' after the condition, found {}", describe(peek().kind)),
           at(TokenKind::kAssign) ? "a comparison for equality is ==" : "");
    }
    node->then_body = statement();
    if (accept(TokenKind::kElse)) {
      accept(TokenKind::kColon);
      node->else_body = statement();
    }
    return finish(std::move(node));
  }

  std::vector<LoopVariable> loop_variables() {
    std::vector<LoopVariable> variables;
    do {
      const Token& name = expect(TokenKind::kName, "as the loop's variable");
      variables.push_back({name.text, name.span, 0});
    } while (accept(TokenKind::kComma));
    expect(TokenKind::kIn, "after the loop's variable", "write for x in list { ... }");
    return variables;
  }

  StmtPtr loop_body() {
    if (!accept(TokenKind::kColon) && !at(TokenKind::kLeftBrace)) {
      fail(fmt::format("expected ':' or '{{' before the loop's body, found {}", describe(peek().kind)),
           at(TokenKind::kAssign) ? "a comparison for equality is ==" : "");
    }
    return statement();
  }

  StmtPtr for_statement() {
    auto node = std::make_unique<ForStmt>(take().span);
    node->variables = loop_variables();
    node->list = expression();
    node->body = loop_body();
    return finish(std::move(node));
  }

  StmtPtr while_statement() {
    auto node = std::make_unique<WhileStmt>(take().span);
    node->condition = expression();
    node->body = loop_body();
    return finish(std::move(node));
  }

  StmtPtr jump_statement() {
    const StmtKind kind = at(TokenKind::kBreak) ? StmtKind::kBreak : StmtKind::kContinue;
    auto node = std::make_unique<JumpStmt>(kind, take().span);
    end_statement();
    return finish(std::move(node));
  }

  StmtPtr return_statement() {
    auto node = std::make_unique<ReturnStmt>(take().span);
    if (!at(TokenKind::kSemicolon) && !at(TokenKind::kRightBrace) && !at(TokenKind::kElse) &&
        !at(TokenKind::kEnd)) {
      do node->values.push_back(expression());
      while (accept(TokenKind::kComma));
    }
    end_statement(!node->values.empty() && node->values.back()->kind == ExprKind::kFunction);
    return finish(std::move(node));
  }

  StmtPtr record_statement() {
    auto node = std::make_unique<RecordStmt>(take().span);
    const Token& name = expect(TokenKind::kName, "as the record's name");
    node->name = name.text;
    node->name_span = name.span;
    node->fields = parameters();
    end_statement();
    return finish(std::move(node));
  }

  StmtPtr param_statement() {
    auto node = std::make_unique<ParamStmt>(take().span);
    const Token& name = expect(TokenKind::kName, "as the param's name");
    node->name = name.text;
    node->name_span = name.span;
    expect(TokenKind::kAssign, "after the param's name", "a param has a default: param groups = 3;");
    node->value = expression();
    end_statement();
    return finish(std::move(node));
  }

  StmtPtr import_statement() {
    auto node = std::make_unique<ImportStmt>(take().span);
    const Token& path =
        expect(TokenKind::kString, "as the file to import", "write import \"std/layout.sol\";");
    node->path = path.text;
    node->path_span = path.span;
    end_statement();
    return finish(std::move(node));
  }

  StmtPtr function_statement() {
    auto node = std::make_unique<AssignStmt>(peek().span);
    const Span start = take().span;
    const Token& name = take();
    node->declares_function = true;
    node->targets.push_back(std::make_unique<NameExpr>(name.span, name.text));
    node->values.push_back(function_from(start, name.text));
    accept(TokenKind::kSemicolon);
    return finish(std::move(node));
  }

  StmtPtr assignment_or_expression() {
    const Span start = peek().span;
    std::vector<ExprPtr> left;
    do left.push_back(expression());
    while (accept(TokenKind::kComma));

    const TokenKind sign = peek().kind;
    const auto* compound = std::find_if(std::begin(kCompoundAssignments), std::end(kCompoundAssignments),
                                        [&](const auto& entry) { return entry.first == sign; });
    if (sign == TokenKind::kAssign) return assignment(start, std::move(left), std::nullopt);
    if (compound != std::end(kCompoundAssignments))
      return assignment(start, std::move(left), compound->second);
    if (left.size() > 1) fail(fmt::format("expected '=' after several variables, found {}", describe(sign)));

    auto node = std::make_unique<ExprStmt>(start);
    node->value = std::move(left.front());
    end_statement(node->value->kind == ExprKind::kFunction);
    return finish(std::move(node));
  }

  StmtPtr assignment(Span start, std::vector<ExprPtr> targets, std::optional<BinaryOp> op) {
    auto node = std::make_unique<AssignStmt>(start);
    node->op = op;
    node->op_span = take().span;
    node->targets = std::move(targets);
    do node->values.push_back(expression());
    while (accept(TokenKind::kComma));
    for (const ExprPtr& target : node->targets) check_target(*target);
    check_counts(*node);
    name_function(*node);
    end_statement(node->values.back()->kind == ExprKind::kFunction);
    return finish(std::move(node));
  }

  void check_target(const Expr& target) {
    const Expr* base = &target;
    while (base->kind == ExprKind::kIndex || base->kind == ExprKind::kField) {
      base = base->kind == ExprKind::kIndex ? static_cast<const IndexExpr*>(base)->object.get()
                                            : static_cast<const FieldExpr*>(base)->object.get();
    }
    if (base->kind == ExprKind::kName || base->kind == ExprKind::kError) return;
    diagnostics_.add(target.span, "this cannot be assigned to",
                     "what stands left of '=' is a variable, its field or its element");
  }

  void check_counts(const AssignStmt& node) {
    const std::size_t targets = node.targets.size();
    const std::size_t values = node.values.size();
    if (node.op && (targets != 1 || values != 1)) {
      diagnostics_.add(node.op_span, "this changes one variable by one value");
    } else if (targets == 1 && values > 1) {
      diagnostics_.add(node.values[1]->span, "one variable, but several values",
                       "put the values in brackets for a list: [a, b]");
    } else if (values != 1 && values != targets) {
      diagnostics_.add(node.op_span, fmt::format("{} variables, but {} values", targets, values));
    }
  }

  /// `area = fun(o) { ... }` gives the function its variable's name.
  static void name_function(AssignStmt& node) {
    for (std::size_t i = 0; i < std::min(node.targets.size(), node.values.size()); ++i) {
      if (node.targets[i]->kind != ExprKind::kName || node.values[i]->kind != ExprKind::kFunction) continue;
      static_cast<FunctionExpr&>(*node.values[i]).function->name =
          static_cast<NameExpr&>(*node.targets[i]).name;
    }
  }

  // ---- expressions

  ExprPtr expression() {
    const Nesting nesting(*this);
    if (at(TokenKind::kIf)) return if_expression();
    return binary(kOrBinding);
  }

  ExprPtr if_expression() {
    auto node = std::make_unique<IfExpr>(take().span);
    node->condition = expression();
    expect(TokenKind::kThen, "after the condition", "as an expression it is: if c then a else b");
    node->then_value = expression();
    expect(TokenKind::kElse, "after the first value", "as an expression it is: if c then a else b");
    node->else_value = expression();
    node->height =
        1 + std::max({node->condition->height, node->then_value->height, node->else_value->height});
    return finish(std::move(node));
  }

  ExprPtr binary(int least_binding) {
    const Span start = peek().span;  // with a parenthesis that the left side's span leaves out
    ExprPtr left = at(TokenKind::kNot) && least_binding <= kComparisonBinding ? not_expression() : unary();
    while (true) {
      const TokenKind kind = peek().kind;
      const bool is_and = kind == TokenKind::kAnd;
      if (is_and || kind == TokenKind::kOr) {
        const int binding = is_and ? kAndBinding : kOrBinding;
        if (binding < least_binding) return left;
        left = logical(start, std::move(left), is_and, binding);
        continue;
      }
      const BinaryLevel* level = binary_level(kind);
      if (level == nullptr || level->binding < least_binding) return left;
      left = binary_with(start, std::move(left), *level);
    }
  }

  ExprPtr not_expression() {
    const Nesting nesting(*this);
    auto node = std::make_unique<UnaryExpr>(take().span, UnaryOp::kNot);
    node->operand = binary(kComparisonBinding);
    node->height = 1 + node->operand->height;
    return finish(std::move(node));
  }

  ExprPtr logical(Span start, ExprPtr left, bool is_and, int binding) {
    auto node = std::make_unique<LogicalExpr>(start, is_and, take().span);
    node->left = std::move(left);
    node->right = binary(binding + 1);
    return finish(checked_height(std::move(node)));
  }

  ExprPtr binary_with(Span start, ExprPtr left, const BinaryLevel& level) {
    auto node = std::make_unique<BinaryExpr>(start, level.op, take().span);
    node->left = std::move(left);
    node->right = binary(level.binding + 1);
    const BinaryLevel* next = binary_level(peek().kind);
    if (level.binding == kComparisonBinding && next != nullptr && next->binding == kComparisonBinding) {
      fail("comparisons do not chain", "write a < b and b < c");
    }
    return finish(checked_height(std::move(node)));
  }

  template <class Node>
  std::unique_ptr<Node> checked_height(std::unique_ptr<Node> node) {
    node->height = 1 + std::max(node->left->height, node->right->height);
    check_height(*node);
    return node;
  }

  void check_height(const Expr& node) {
    if (node.height > kHighestTree)
      fail("this expression is too long", "compute parts of it in variables first");
  }

  ExprPtr unary() {
    if (!at(TokenKind::kMinus)) return postfix();
    const Nesting nesting(*this);
    auto node = std::make_unique<UnaryExpr>(take().span, UnaryOp::kNegate);
    node->operand = unary();
    node->height = 1 + node->operand->height;
    return finish(std::move(node));
  }

  ExprPtr postfix() {
    const Span start = peek().span;
    ExprPtr value = primary();
    while (true) {
      if (at(TokenKind::kLeftParen)) {
        value = call(start, std::move(value));
      } else if (at(TokenKind::kLeftBracket)) {
        value = index(start, std::move(value));
      } else if (at(TokenKind::kDot)) {
        value = field(start, std::move(value));
      } else {
        return value;
      }
      check_height(*value);
    }
  }

  ExprPtr call(Span start, ExprPtr callee) {
    auto node = std::make_unique<CallExpr>(start);
    node->height = 1 + callee->height;
    node->callee = std::move(callee);
    const Span open = take().span;
    while (!at(TokenKind::kRightParen)) {
      if (at(TokenKind::kEnd)) close_missing(open, "(");
      node->arguments.push_back(argument());
      node->height = std::max(node->height, 1 + node->arguments.back().value->height);
      if (!accept(TokenKind::kComma)) break;
    }
    expect(TokenKind::kRightParen, "to close the arguments");
    return finish(std::move(node));
  }

  [[noreturn]] void close_missing(Span open, const std::string& bracket) {
    diagnostics_.add(open, fmt::format("this '{}' is never closed", bracket));
    throw Unreadable{};
  }

  Argument argument() {
    Argument made;
    if (at(TokenKind::kName) && peek(1).kind == TokenKind::kColon) {
      made.name = peek().text;
      made.name_span = take().span;
      take();
    }
    made.value = expression();
    return made;
  }

  ExprPtr index(Span start, ExprPtr object) {
    auto node = std::make_unique<IndexExpr>(start);
    take();
    node->object = std::move(object);
    node->index = expression();
    expect(TokenKind::kRightBracket, "to close the index");
    node->height = 1 + std::max(node->object->height, node->index->height);
    return finish(std::move(node));
  }

  ExprPtr field(Span start, ExprPtr object) {
    auto node = std::make_unique<FieldExpr>(start);
    take();
    node->object = std::move(object);
    const Token& name = expect(TokenKind::kName, "after '.'");
    node->field = name.text;
    node->field_span = name.span;
    node->height = 1 + node->object->height;
    return finish(std::move(node));
  }

  ExprPtr primary() {
    const Token token = peek();
    switch (token.kind) {
      case TokenKind::kInt:
        return literal(token.int_value);
      case TokenKind::kFloat:
        return literal(token.float_value);
      case TokenKind::kString:
        return literal(token.text);
      case TokenKind::kTrue:
        return literal(true);
      case TokenKind::kFalse:
        return literal(false);
      case TokenKind::kNil:
        return literal(std::monostate{});
      case TokenKind::kName:
        take();
        return std::make_unique<NameExpr>(token.span, token.text);
      case TokenKind::kLeftParen:
        return parenthesized();
      case TokenKind::kLeftBracket:
        return list();
      case TokenKind::kFun:
        take();
        return function_from(token.span, "");
      case TokenKind::kNot:
        fail("'not' binds weaker than this operator", "put it in parentheses: (not a)");
      case TokenKind::kAssign:
        fail("expected an expression, found '='", "a comparison for equality is ==");
      case TokenKind::kPlus:
        fail("expected an expression, found '+'", "to count up, write n += 1");
      case TokenKind::kLeftBrace:
        fail("expected an expression, found '{'", "lists stand in [ ]; values with named fields are records");
      default:
        fail(fmt::format("expected an expression, found {}", describe(token.kind)));
    }
  }

  ExprPtr literal(LiteralExpr::Constant value) {
    return std::make_unique<LiteralExpr>(take().span, std::move(value));
  }

  ExprPtr parenthesized() {
    const Span open = take().span;
    ExprPtr value = expression();
    if (at(TokenKind::kEnd)) close_missing(open, "(");
    expect(TokenKind::kRightParen, "to close '('", at(TokenKind::kComma) ? "a list is written [a, b]" : "");
    return value;
  }

  ExprPtr list() {
    const Span open = take().span;
    auto node = std::make_unique<ListExpr>(open);
    while (!at(TokenKind::kRightBracket)) {
      if (at(TokenKind::kEnd)) close_missing(open, "[");
      node->items.push_back(expression());
      node->height = std::max(node->height, 1 + node->items.back()->height);
      if (node->items.size() == 1 && at(TokenKind::kFor))
        return comprehension(open, std::move(node->items.front()));
      if (!accept(TokenKind::kComma)) break;
    }
    expect(TokenKind::kRightBracket, "to close the list");
    return finish(std::move(node));
  }

  ExprPtr comprehension(Span open, ExprPtr element) {
    auto node = std::make_unique<ComprehensionExpr>(open);
    node->height = 1 + element->height;
    node->element = std::move(element);
    while (at(TokenKind::kFor)) {
      node->clauses.push_back(clause());
      node->height = std::max(node->height, 1 + node->clauses.back().list->height);
      for (const ExprPtr& condition : node->clauses.back().conditions) {
        node->height = std::max(node->height, 1 + condition->height);
      }
    }
    if (node->clauses.size() > static_cast<std::size_t>(kDeepestNesting)) fail("this nests too deeply");
    expect(TokenKind::kRightBracket, "to close the list");
    return finish(std::move(node));
  }

  ComprehensionClause clause() {
    ComprehensionClause made;
    made.span = take().span;
    made.variables = loop_variables();
    made.list = binary(kOrBinding);  // an if behind it is the clause's condition
    while (accept(TokenKind::kIf)) made.conditions.push_back(expression());
    return made;
  }

  std::vector<Parameter> parameters() {
    std::vector<Parameter> made;
    expect(TokenKind::kLeftParen, "before the parameters");
    while (!at(TokenKind::kRightParen)) {
      const Token& name = expect(TokenKind::kName, "as a parameter");
      Parameter parameter{name.text, name.span, nullptr};
      for (const Parameter& earlier : made) {
        if (earlier.name == parameter.name) {
          diagnostics_.add(parameter.span, fmt::format("two parameters are called '{}'", parameter.name));
        }
      }
      if (accept(TokenKind::kAssign)) {
        parameter.default_value = expression();
      } else if (!made.empty() && made.back().default_value) {
        diagnostics_.add(parameter.span,
                         fmt::format("'{}' stands behind a parameter with a default", parameter.name),
                         "give it a default too, or move it to the front");
      }
      made.push_back(std::move(parameter));
      if (!accept(TokenKind::kComma)) break;
    }
    expect(TokenKind::kRightParen, "to close the parameters");
    return made;
  }

  /// Behind `fun` and a name, if there is one.
  std::unique_ptr<FunctionExpr> function_from(Span start, std::string name) {
    const Nesting nesting(*this);
    auto node = std::make_unique<FunctionExpr>(start);
    node->function = std::make_unique<Function>();
    node->function->name = std::move(name);
    node->function->parameters = parameters();
    node->function->body = block();
    node->function->span = cover(start, previous().span);
    return finish(std::move(node));
  }

  Diagnostics& diagnostics_;
  TokenList list_;
  const SourceSet& sources_;
  std::size_t at_ = 0;
  int nesting_ = 0;
};

}  // namespace

SyntaxTree parse(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics) {
  return Parser(sources, source, diagnostics).parse_file();
}

ExprPtr parse_expression(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics) {
  return Parser(sources, source, diagnostics).parse_whole_expression();
}

}  // namespace solitaire
