#pragma once
#include <memory>
#include <set>
#include <unordered_map>

#include "solitaire/run/evaluation.h"

namespace solitaire {

/// The walk over the tree: evaluates expressions, runs statements and makes calls. The layers below it know
/// where it goes (control.h), what it computes (operators.h, structures.h), and what is written down
/// (effects.h).
class Walk : public Evaluator {
 public:
  /// Without a graph, the program is run with every choice answered. Without branches, it goes where known
  /// conditions lead.
  Walk(const Program& program, const ParamValues& params, AddressTable& addresses, const Limits& limits,
       Graph* graph, Branches* branches);
  ~Walk();

  /// Runs the script from its start; the value is Unset if no path comes to its end.
  Value run(Choices& choices, Effects& effects, std::uint32_t levels = 0);
  std::uint64_t steps() const { return total_steps_; }
  const Path& path() const { return path_; }

 private:
  struct Summary;  // of a call that exclusive branches share
  struct Segment;  // a summary in the making
  class Iteration;
  using NamedValues = std::vector<std::pair<const Argument*, Value>>;

  // calls.cpp
  Value run_module(std::uint32_t module);
  Value call(const CallExpr& node);
  Value call_with_names(const Value& callee, const CallExpr& site);
  Value call_value(const Value& callee, const CallExpr& site, std::vector<Value> positional,
                   NamedValues named);
  Value call_closure(const Closure& closure, const CallExpr& site);
  Value call_closure(const Closure& closure, const CallExpr& site, std::vector<Value> arguments);
  Value call_builtin(const Builtin& builtin, const CallExpr& site);
  Value call_builtin(const Builtin& builtin, const CallExpr& site, std::vector<Value> positional,
                     NamedValues named);
  Value construct(const RecordType& type, const CallExpr& site, std::vector<Value> arguments);
  std::vector<Value> bind(const std::string& name, const std::vector<Parameter>& parameters,
                          const CallExpr& site, std::vector<Value> positional, NamedValues named);
  Activation activation_of(const Closure& closure, const CallExpr& site);
  void set_defaults(Activation& activation, std::size_t first, std::size_t end);
  Value run_body(Activation& activation);
  std::vector<Slot> slots_kept(const Activation& activation) const;
  void check_required(const Builtin& builtin, const CallExpr& site, std::span<const Value> arguments);

  // summaries.cpp
  bool is_shared(const CallExpr& site) const {
    return forks_ && site.site.shared && path_.guard_since(current_->region) != kTrue;
  }
  Value call_shared(const Ref<Closure>& closure, const CallExpr& site, std::vector<Value> arguments);
  const Summary* find_summary(AddressId address, const Closure& closure, const std::vector<Value>& arguments);
  Value use_summary(const Summary& summary);
  void note_read(const Frame& frame, Slot slot, const Value& value) {
    if (!segments_.empty()) note_read_in_segment(frame, slot, value);
  }
  void note_read_in_segment(const Frame& frame, Slot slot, const Value& value);

  // statements.cpp
  bool statement(const Stmt& node);
  bool block(const BlockStmt& node);
  bool if_statement(const IfStmt& node);
  void assignment(const AssignStmt& node);
  bool return_statement(const ReturnStmt& node);
  bool jump(const Stmt& node);
  void param(const ParamStmt& node);
  void assign(const Expr& target, Value value);
  void change(const Expr& target, const Change& change);
  void update(const Expr& target, std::span<const Value> indices, const Change& change);

  // loops.cpp
  bool for_statement(const ForStmt& node);
  bool while_statement(const WhileStmt& node);
  template <class Enter>
  bool run_loop(const Stmt& body, std::span<const Slot> assigned, Enter enter);
  bool turn(const Stmt& body, Loop& loop);
  bool enter_turn(const Value& more, const Site& site, Span span, Exits& ends, std::span<const Slot> assigned,
                  const Value& value, std::size_t region);
  void set_variables(const std::vector<LoopVariable>& variables, const Value& value, Span span);
  Value comprehension(const ComprehensionExpr& node);
  void clause(const ComprehensionExpr& node, std::size_t number, Value& collected);
  void conditions(const ComprehensionExpr& node, std::size_t clause_number, std::size_t number,
                  Value& collected);
  Value up_to(const Value& first, const Value& last, Span span);
  Value chosen_range(const Value& first, const Value& last, Span span);

  // expressions.cpp
  Value expression(const Expr& node);
  /// The value of an expression: that of a local variable where it stands, else what `storage` is set to.
  const Value& operand(const Expr& node, Value& storage);
  Value literal(const LiteralExpr& node);
  Value name(const NameExpr& node);
  Value list(const ListExpr& node);
  Value unary_expression(const UnaryExpr& node);
  Value binary_expression(const BinaryExpr& node);
  Value logical(const LogicalExpr& node);
  Value if_expression(const IfExpr& node);
  bool assert_apart(const CallExpr& node);
  void assert_conjuncts(const Expr& condition, Span whole, const std::string& message);
  Value function(const FunctionExpr& node);
  Value read(const Frame& frame, Slot slot, const NameExpr& node);
  Value tested(const Expr& node) {
    Value storage;
    return condition(operand(node, storage), node.span);
  }

  std::unordered_map<AddressId, std::vector<std::unique_ptr<Summary>>> summaries_;
  std::vector<Segment*> segments_;
};

}  // namespace solitaire
