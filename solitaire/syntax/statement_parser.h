#pragma once
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solitaire/syntax/expression_parser.h"

namespace solitaire {

/// Reads statements and whole files. Every statement recovers from its own errors.
class StatementParser final : public ExpressionParser {
 public:
  using ExpressionParser::ExpressionParser;

  SyntaxTree file();
  /// Reads a source that is a single expression.
  ExprPtr only_expression();

 private:
  std::unique_ptr<BlockStmt> block() override;
  StmtPtr recovering_statement();
  StmtPtr statement();
  StmtPtr if_statement();
  StmtPtr for_statement();
  StmtPtr while_statement();
  StmtPtr loop_body();
  StmtPtr body();
  StmtPtr jump_statement();
  StmtPtr output_statement();
  StmtPtr auxiliary_statement();
  bool at_word(std::string_view word, TokenKind next) const;
  StmtPtr return_statement();
  StmtPtr record_statement();
  StmtPtr param_statement();
  StmtPtr import_statement();
  StmtPtr function_statement();
  StmtPtr assignment_or_expression();
  StmtPtr assignment(std::unique_ptr<AssignStmt> node, std::vector<ExprPtr> targets);
  void check_target(const Expr& target);
  void check_counts(const AssignStmt& node);
  void semicolon(bool ends_with_function = false);
  static bool is_else_if(const Token& token);
  std::string foreign_keyword_help() const;
};

}  // namespace solitaire
