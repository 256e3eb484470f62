#pragma once
#include <cstdint>
#include <optional>

#include "solitaire/run/assignments.h"

namespace solitaire {

/// The walk over the tree: evaluates expressions and runs statements. The layers below it, each with a header
/// of its own, have its larger parts.
class Walk final : public Assignments {
 public:
  /// Without a graph, the program is run with every choice answered. Without branches, it goes where known
  /// conditions lead.
  Walk(const Program& program, const ParamValues& params, AddressTable& addresses, const Limits& limits,
       Graph* graph, Branches* branches)
      : Assignments(program, params, addresses, limits, graph, branches) {}

  /// Runs the script from its start; the value is Unset if no path comes to its end.
  Value run(Choices& choices, Effects& effects, std::uint32_t levels = 0);
  /// Runs the output of the script, right after run() came to its end: returns what it returns, or else the
  /// value.
  Value run_output(const OutputStmt& output, Effects& effects, Value value);
  std::uint64_t steps() const { return total_steps_; }
  const Path& path() const { return path_; }

 private:
  /// Returns true if a trace had better show both sides of a branch, where that can be: who weighs executions
  /// goes from one to the other, over and over.
  bool shows_both_sides(const Value& condition) const { return condition.traced() && choices_->weighs(); }

  // statements.cpp
  bool statement(const Stmt& node) override;
  bool if_statement(const IfStmt& node);
  bool weigh_both_sides(const Value& condition, const IfStmt& node);
  bool return_statement(const ReturnStmt& node);
  bool jump(const Stmt& node);
  void param(const ParamStmt& node);

  // expressions.cpp
  Value expression(const Expr& node) override;
  Value list(const ListExpr& node);
  Value unary_expression(const UnaryExpr& node);
  Value binary_expression(const BinaryExpr& node);
  Value membership(const BinaryExpr& node);
  Value element_of(const IndexExpr& node);
  Value logical(const LogicalExpr& node);
  Value if_expression(const IfExpr& node);
  std::optional<Value> of_both_sides(const Value& condition, const IfExpr& node);
  Value function(const FunctionExpr& node);
};

}  // namespace solitaire
