#pragma once
#include <memory>
#include <string>
#include <vector>

#include "solitaire/syntax/syntax.h"
#include "solitaire/syntax/token_reader.h"

namespace solitaire {

/// Reads expressions, by recursive descent with a binding strength for each binary operator. After an error
/// it returns what it has read so far, with an ErrorExpr for what is missing.
class ExpressionParser : public TokenReader {
 public:
  virtual ~ExpressionParser() = default;

 protected:
  using TokenReader::TokenReader;

  ExprPtr expression();
  std::vector<Parameter> parameters();
  /// Reads `x, y in`.
  std::vector<LoopVariable> loop_variables();
  /// Reads a function from its parameters on; `start` is where its `fun` stands.
  std::unique_ptr<FunctionExpr> function_from(Span start, std::string name);
  /// Reads the body of a function.
  virtual std::unique_ptr<BlockStmt> block() = 0;

 private:
  ExprPtr if_expression();
  ExprPtr binary(int least_binding);
  ExprPtr not_expression();
  ExprPtr not_in(Span start, ExprPtr left);
  ExprPtr logical(Span start, ExprPtr left, bool is_and, int binding);
  ExprPtr comparison_or_arithmetic(Span start, ExprPtr left, BinaryOp op, int binding);
  ExprPtr unary();
  ExprPtr postfix();
  ExprPtr call(Span start, ExprPtr callee);
  Argument argument();
  ExprPtr index(Span start, ExprPtr object);
  ExprPtr field(Span start, ExprPtr object);
  ExprPtr primary();
  ExprPtr literal(LiteralExpr::Constant value);
  ExprPtr missing();
  ExprPtr parenthesized();
  ExprPtr list();
  ExprPtr comprehension(Span open, ExprPtr element);
  ComprehensionClause clause();
  Parameter parameter(const std::vector<Parameter>& earlier);
  void grow(Expr& node, int height_of_child);

  int tallest_ = 0;  // the height of the highest expression so far in the current function
};

}  // namespace solitaire
