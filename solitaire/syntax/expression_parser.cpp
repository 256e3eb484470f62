#include "solitaire/syntax/expression_parser.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace solitaire {
namespace {

/// The tree of an expression is no higher than this, with the functions in it; the tree of a chain such as
/// a + b + c is as high as the chain is long. So walking a tree by recursion needs a bounded stack.
constexpr int kHighestTree = 1000;

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
    {TokenKind::kIn, kComparisonBinding, BinaryOp::kIn},
    {TokenKind::kDotDot, 5, BinaryOp::kUpTo},
    {TokenKind::kPlus, 6, BinaryOp::kAdd},
    {TokenKind::kMinus, 6, BinaryOp::kSubtract},
    {TokenKind::kStar, 7, BinaryOp::kMultiply},
    {TokenKind::kSlash, 7, BinaryOp::kDivide},
    {TokenKind::kPercent, 7, BinaryOp::kModulo},
};

const BinaryLevel* binary_level(TokenKind token) {
  const auto* level = std::find_if(std::begin(kBinary), std::end(kBinary),
                                   [&](const BinaryLevel& candidate) { return candidate.token == token; });
  return level == std::end(kBinary) ? nullptr : level;
}

}  // namespace

ExprPtr ExpressionParser::expression() {
  const Nesting nesting(*this);
  return at(TokenKind::kIf) ? if_expression() : binary(kOrBinding);
}

/// Makes a node higher than a child.
void ExpressionParser::grow(Expr& node, int height_of_child) {
  node.height = std::max(node.height, 1 + height_of_child);
  tallest_ = std::max(tallest_, node.height);
  if (node.height > kHighestTree)
    fail("this expression is too long", "compute parts of it in variables first");
}

// ---- operators

ExprPtr ExpressionParser::if_expression() {
  auto node = std::make_unique<IfExpr>(take().span);
  node->condition = expression();
  expect(TokenKind::kThen, "after the condition", "as an expression it is: if c then a else b");
  node->then_value = expression();
  expect(TokenKind::kElse, "after the first value", "as an expression it is: if c then a else b");
  node->else_value = expression();
  grow(*node, std::max({node->condition->height, node->then_value->height, node->else_value->height}));
  return finish(std::move(node));
}

ExprPtr ExpressionParser::binary(int least_binding) {
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
    if (kind == TokenKind::kNot && peek(1).kind == TokenKind::kIn && least_binding <= kComparisonBinding) {
      left = not_in(start, std::move(left));
      continue;
    }
    const BinaryLevel* level = binary_level(kind);
    if (level == nullptr || level->binding < least_binding) return left;
    left = comparison_or_arithmetic(start, std::move(left), level->op, level->binding);
  }
}

ExprPtr ExpressionParser::not_expression() {
  const Nesting nesting(*this);
  auto node = std::make_unique<UnaryExpr>(take().span, UnaryOp::kNot);
  node->operand = binary(kComparisonBinding);
  grow(*node, node->operand->height);
  return finish(std::move(node));
}

/// `x not in list` is read as `not x in list`.
ExprPtr ExpressionParser::not_in(Span start, ExprPtr left) {
  auto node = std::make_unique<UnaryExpr>(start, UnaryOp::kNot);
  take();
  node->operand = comparison_or_arithmetic(start, std::move(left), BinaryOp::kIn, kComparisonBinding);
  grow(*node, node->operand->height);
  return finish(std::move(node));
}

ExprPtr ExpressionParser::logical(Span start, ExprPtr left, bool is_and, int binding) {
  auto node = std::make_unique<LogicalExpr>(start, is_and, take().span);
  node->left = std::move(left);
  node->right = binary(binding + 1);
  grow(*node, std::max(node->left->height, node->right->height));
  return finish(std::move(node));
}

ExprPtr ExpressionParser::comparison_or_arithmetic(Span start, ExprPtr left, BinaryOp op, int binding) {
  auto node = std::make_unique<BinaryExpr>(start, op, take().span);
  node->left = std::move(left);
  node->right = binary(binding + 1);
  const BinaryLevel* next = binary_level(peek(at(TokenKind::kNot) ? 1 : 0).kind);
  if (binding == kComparisonBinding && next != nullptr && next->binding == kComparisonBinding)
    fail("comparisons do not chain", "write a < b and b < c");
  grow(*node, std::max(node->left->height, node->right->height));
  return finish(std::move(node));
}

ExprPtr ExpressionParser::unary() {
  if (!at(TokenKind::kMinus)) return postfix();
  const Nesting nesting(*this);
  auto node = std::make_unique<UnaryExpr>(take().span, UnaryOp::kNegate);
  node->operand = unary();
  grow(*node, node->operand->height);
  return finish(std::move(node));
}

// ---- calls, indices, fields

ExprPtr ExpressionParser::postfix() {
  const Span start = peek().span;
  ExprPtr value = primary();
  while (true) {
    switch (peek().kind) {
      case TokenKind::kLeftParen:
        value = call(start, std::move(value));
        break;
      case TokenKind::kLeftBracket:
        value = index(start, std::move(value));
        break;
      case TokenKind::kDot:
        value = field(start, std::move(value));
        break;
      default:
        return value;
    }
  }
}

ExprPtr ExpressionParser::call(Span start, ExprPtr callee) {
  auto node = std::make_unique<CallExpr>(start);
  grow(*node, callee->height);
  node->callee = std::move(callee);
  const Span open = take().span;
  while (!at(TokenKind::kRightParen) && !never_closed(open, "(")) {
    node->arguments.push_back(argument());
    grow(*node, node->arguments.back().value->height);
    if (!accept(TokenKind::kComma)) break;
  }
  expect(TokenKind::kRightParen, "to close the arguments",
         at(TokenKind::kAssign) ? "a comparison for equality is ==; an argument is named by a colon: f(x: 3)"
                                : "");
  return finish(std::move(node));
}

Argument ExpressionParser::argument() {
  Argument made;
  if (at(TokenKind::kName) && peek(1).kind == TokenKind::kColon) {
    made.name = peek().text;
    made.name_span = take().span;
    take();
  }
  made.value = expression();
  return made;
}

ExprPtr ExpressionParser::index(Span start, ExprPtr object) {
  auto node = std::make_unique<IndexExpr>(start);
  take();
  node->object = std::move(object);
  node->index = expression();
  expect(TokenKind::kRightBracket, "to close the index");
  grow(*node, std::max(node->object->height, node->index->height));
  return finish(std::move(node));
}

ExprPtr ExpressionParser::field(Span start, ExprPtr object) {
  auto node = std::make_unique<FieldExpr>(start);
  take();
  node->object = std::move(object);
  const bool is_number = node->object->kind == ExprKind::kLiteral && !at(TokenKind::kInt);
  const Token& name =
      expect(TokenKind::kName, "after '.'", is_number ? "a float ends with a digit: 5.0" : "");
  node->field = name.text;
  node->field_span = name.span;
  grow(*node, node->object->height);
  return finish(std::move(node));
}

// ---- what operators combine

ExprPtr ExpressionParser::primary() {
  const Token& token = peek();
  switch (token.kind) {
    case TokenKind::kInt:
      return literal(token.int_value);
    case TokenKind::kFloat:
      return literal(token.float_value);
    case TokenKind::kString:
      return literal(token.text);
    case TokenKind::kTrueWord:
      return literal(true);
    case TokenKind::kFalseWord:
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
    default:
      return missing();
  }
}

ExprPtr ExpressionParser::literal(LiteralExpr::Constant value) {
  return std::make_unique<LiteralExpr>(take().span, std::move(value));
}

/// Reports that there is no expression here.
ExprPtr ExpressionParser::missing() {
  switch (peek().kind) {
    case TokenKind::kNot:
      fail("'not' binds weaker than this operator", "put it in parentheses: (not a)");
      break;
    case TokenKind::kAssign:
      fail("expected an expression, found '='", "a comparison for equality is ==");
      break;
    case TokenKind::kPlus:
      fail("expected an expression, found '+'", "to count up, write n += 1");
      break;
    case TokenKind::kStar:
      fail("expected an expression, found '*'",
           previous().kind == TokenKind::kStar ? "a power is written pow(x, y), or x * x" : "");
      break;
    case TokenKind::kDot:
      fail("expected an expression, found '.'",
           peek(1).kind == TokenKind::kInt ? "a float starts with a digit: 0.5" : "");
      break;
    case TokenKind::kLeftBrace:
      fail("expected an expression, found '{'", "lists stand in [ ]; values with named fields are records");
      break;
    default:
      fail(fmt::format("expected an expression, found {}", describe(peek().kind)));
  }
  return std::make_unique<ErrorExpr>(peek().span);
}

ExprPtr ExpressionParser::parenthesized() {
  const Span open = take().span;
  ExprPtr value = expression();
  if (!never_closed(open, "(")) {
    expect(TokenKind::kRightParen, "to close '('", at(TokenKind::kComma) ? "a list is written [a, b]" : "");
  }
  value->parentheses = cover(open, previous().span);
  return value;
}

ExprPtr ExpressionParser::list() {
  const Span open = take().span;
  auto node = std::make_unique<ListExpr>(open);
  while (!at(TokenKind::kRightBracket) && !never_closed(open, "[")) {
    node->items.push_back(expression());
    grow(*node, node->items.back()->height);
    if (node->items.size() == 1 && at(TokenKind::kFor))
      return comprehension(open, std::move(node->items.front()));
    if (!accept(TokenKind::kComma)) break;
  }
  expect(TokenKind::kRightBracket, "to close the list");
  return finish(std::move(node));
}

ExprPtr ExpressionParser::comprehension(Span open, ExprPtr element) {
  auto node = std::make_unique<ComprehensionExpr>(open);
  grow(*node, element->height);
  node->element = std::move(element);
  while (at(TokenKind::kFor)) {
    node->clauses.push_back(clause());
    grow(*node, node->clauses.back().list->height);
    for (const ExprPtr& condition : node->clauses.back().conditions) grow(*node, condition->height);
  }
  distrust_names(open);
  if (node->clauses.size() > static_cast<std::size_t>(kDeepestNesting)) fail("this nests too deeply");
  expect(TokenKind::kRightBracket, "to close the list");
  return finish(std::move(node));
}

ComprehensionClause ExpressionParser::clause() {
  const Nesting nesting(*this);
  ComprehensionClause made;
  made.span = take().span;
  made.variables = loop_variables();
  made.list = binary(kOrBinding);  // an if behind it is the clause's condition
  while (accept(TokenKind::kIf)) made.conditions.push_back(expression());
  return made;
}

std::vector<LoopVariable> ExpressionParser::loop_variables() {
  std::vector<LoopVariable> variables;
  do {
    const Token& name = expect(TokenKind::kName, "as the loop's variable",
                               at(TokenKind::kLeftParen) ? "write for i in 0..n - 1 { ... }" : "");
    if (panicking()) return variables;
    variables.push_back({name.text, name.span, 0});
  } while (accept(TokenKind::kComma));
  expect(TokenKind::kIn, "after the loop's variable", "write for x in list { ... }");
  return variables;
}

// ---- functions

std::vector<Parameter> ExpressionParser::parameters() {
  std::vector<Parameter> made;
  expect(TokenKind::kLeftParen, "before the parameters");
  while (!panicking() && !at(TokenKind::kRightParen)) {
    Parameter next = parameter(made);
    if (next.name.empty()) break;
    made.push_back(std::move(next));
    if (!accept(TokenKind::kComma)) break;
  }
  expect(TokenKind::kRightParen, "to close the parameters");
  return made;
}

/// Reads a parameter; its name is empty if there is none.
Parameter ExpressionParser::parameter(const std::vector<Parameter>& earlier) {
  const Token& name = expect(TokenKind::kName, "as a parameter");
  Parameter made{name.text, name.span, nullptr};
  const auto same = std::find_if(earlier.begin(), earlier.end(),
                                 [&](const Parameter& other) { return other.name == made.name; });
  if (same != earlier.end()) {
    report({made.span,
            fmt::format("two parameters are called '{}'", made.name),
            "",
            {},
            Severity::kError,
            "duplicate-parameter",
            {{same->span, "the other one is here"}}});
  }
  if (accept(TokenKind::kAssign)) {
    made.default_value = expression();
  } else if (!earlier.empty() && earlier.back().default_value) {
    report("parameter-order", made.span,
           fmt::format("'{}' stands behind a parameter with a default", made.name),
           "give it a default too, or move it to the front");
  }
  return made;
}

std::unique_ptr<FunctionExpr> ExpressionParser::function_from(Span start, std::string name) {
  const Nesting nesting(*this);
  const int tallest_outside = std::exchange(tallest_, 0);
  auto node = std::make_unique<FunctionExpr>(start);
  node->function = std::make_unique<Function>();
  node->function->name = std::move(name);
  node->function->parameters = parameters();
  recover_at_block();
  node->function->body = block();
  grow(*node, tallest_);
  tallest_ = std::max(tallest_, tallest_outside);
  node = finish(std::move(node));
  node->function->span = node->span;
  return node;
}

}  // namespace solitaire
