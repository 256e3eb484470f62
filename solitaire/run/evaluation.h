#pragma once
#include <array>
#include <functional>
#include <memory>
#include <set>
#include <span>
#include <unordered_map>

#include "solitaire/run/evaluator.h"
#include "solitaire/run/path.h"
#include "solitaire/value/merge.h"
#include "tracegraph/trace.h"

// The one evaluator, seen from its parts: evaluator.cpp, branching.cpp, deciding.cpp, calls.cpp,
// summaries.cpp, statements.cpp, iteration.cpp, expressions.cpp, operators.cpp, elements.cpp and
// builtins.cpp. Users of the library include evaluator.h.

namespace solitaire {

/// Whether a builtin was called with that argument.
inline bool given(const Value& argument) { return !argument.is<Value::Unset>(); }

/// Paths that left a construct early, merged into one state: by return, break or continue, or a loop's end.
struct Exits {
  bool any = false;
  NodeId guard = kFalse;  // since the region that they leave to began
  std::vector<Value> slots;
  Value value;
};

/// A running call.
struct Activation {
  const Function* function = nullptr;
  Ref<Frame> frame;
  std::uint32_t module = 0;
  Activation* caller = nullptr;
  const CallExpr* call = nullptr;  // where the caller called, or null
  AddressId address;               // once it has been asked for
  bool has_address = false;
  std::vector<std::uint32_t> turns;  // of the loops around the point where it runs
  std::size_t region = 0;            // of the path
  Exits returns;
};

/// A loop that runs; breaks and continues lead to it.
struct Loop {
  std::span<const Slot> assigned;
  std::size_t turn_region = 0;
  std::size_t region = 0;
  Exits breaks;     // and where its condition ended it
  Exits continues;  // of the current turn
};

class Evaluator {
 public:
  Evaluator(const Program& program, const ParamValues& params, Choices& choices, Branches* branches,
            Graph& graph, AddressTable& addresses, TraceRecorder* recorder, const Limits& limits);
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// Runs the script; the value is Unset if no path comes to its end.
  Value run(std::uint32_t levels = 0);
  Execution take_execution() { return std::move(execution_); }
  /// What a symbolic pass found, but for its trace and value.
  SymbolicPass take_pass();

  // ---- branching.cpp: paths, what rules executions out, and mistakes

  bool symbolic() const { return recorder_ != nullptr; }
  Graph& graph() { return graph_; }
  /// Counts work, and ends the path or the evaluation at a limit.
  void step(Span span, std::uint64_t count = 1);
  /// The path ends here without a reason of its own: everything below it ended.
  [[noreturn]] void end_path();
  /// Every execution on this path is ruled out.
  [[noreturn]] void reject(ConstraintKind requirement, Span span, const std::string& message = "",
                           std::optional<AddressId> at = std::nullopt);
  /// Executions on this path for which the condition fails are ruled out. `at`: of the choice, if it is about
  /// one.
  void require(NodeId condition, ConstraintKind requirement, Span span, const std::string& message = "",
               std::optional<AddressId> at = std::nullopt);
  /// The program is wrong on this path.
  [[noreturn]] void program_error(Span span, const std::string& message, const std::string& help = "");
  /// The program is wrong for those executions on this path for which the condition, a bool, holds. If that
  /// depends on floats that depend on choices, it is left to the replays of solutions.
  void program_error_if(const Value& wrong, Span span, const std::string& message,
                        const std::string& help = "");
  /// The program may be right here, but a symbolic pass cannot go on.
  [[noreturn]] void unsupported(Span span, const std::string& message, const std::string& help = "");
  /// What happens here shows only when an execution is run.
  void leave_to_run() { complete_ = false; }
  /// Whether only some executions come here.
  bool guarded() const { return path_.guarded(); }
  /// graph().apply, with what it throws turned into mistakes.
  NodeId apply(Op op, std::initializer_list<NodeId> operands, Span span);
  /// A wish of the program: executions that come here cost so much.
  void wish(const Value& cost, const CallExpr& site);

  /// Runs one part for each guard, on forked states, and merges what they leave behind. The guards exclude
  /// each other and one of them holds. A part returns whether its path goes on, and may leave a value.
  /// Returns whether any path goes on.
  template <class Part>
  bool split(std::span<const NodeId> guards, std::span<const Slot> assigned, Value& value, Part part);
  /// A branch at a site: both sides if they are open. `value` as for split.
  template <class Then, class Else>
  bool branch(NodeId condition, const Site& site, Span span, std::span<const Slot> assigned, Value& value,
              Then then_part, Else else_part);
  /// branch() for expressions: each side gives a value.
  template <class Then, class Else>
  Value choose_side(NodeId condition, const Site& site, Span span, std::span<const Slot> assigned,
                    Then then_value, Else else_value);
  /// f of a value that is no union: of each alternative, merged.
  template <class Function>
  Value each_shape(const Value& value, Function f);

  // ---- calls.cpp

  Value call_value(const Value& callee, const CallExpr& site, std::vector<Value> positional,
                   std::vector<std::pair<const Argument*, Value>> named);
  /// The address of a site of the running function, in the current turns of its loops.
  AddressId address_of(std::string_view label);
  AddressId address_of(const Site& site) { return address_of(program_.labels[site.label]); }
  Value decide(const CallExpr& site, const Value& lo, const Value& hi, const Value& step,
               Distribution::Family kind);
  void place(Placement placement, const BuiltinCall& call);
  Execution& execution() { return execution_; }
  const std::string& text(AddressId address) const { return addresses_.text(address); }
  const SourceSet& sources() const { return program_.sources; }

  // ---- operators.cpp

  Value arithmetic(BinaryOp op, const Value& a, const Value& b, Span span);
  Value negated(const Value& value, Span span);
  Value compare(BinaryOp op, const Value& a, const Value& b, Span span);
  /// Structural equality, as a bool.
  Value equal(const Value& a, const Value& b);
  Value invert(const Value& condition);
  Value opaque_string(Span span);
  /// For what needs to know what a string says.
  void check_known(const Value& text);
  /// Of bools that are no unions.
  Value both(const Value& a, const Value& b);
  Value either(const Value& a, const Value& b);
  /// The node of a value used as a condition; a mistake if it is no bool.
  NodeId condition(const Value& value, Span span);
  /// min, max: of two numbers.
  Value pick(Op int_op, const Value& a, const Value& b, Span span);
  Value to_float(const Value& number, Span span);
  Value unary(Op op, const Value& value, Span span);

  // ---- elements.cpp

  Value element(const Value& object, const Value& index, Span span);
  Value field(const Value& object, const FieldExpr& access);
  void assign(const Expr& target, Value value);
  void take_apart(const Value& value, std::size_t count, Span span,
                  const std::function<void(std::size_t, Value)>& give);
  Value make_list(std::vector<Value> items, Span span);
  Value make_record(const RecordStmt* type, std::vector<Value> fields, Span span);
  /// f of the items of a list; a mistake if the value is none. `user` is what needs it, for the message.
  Value with_items(const Value& value, const char* user, Span span,
                   const std::function<Value(const std::vector<Value>&)>& f);

  // ---- iteration.cpp

  Value up_to(const Value& first, const Value& last, Span span);

 private:
  struct State;    // of the variables and the path, where branches fork
  struct Summary;  // of a call that exclusive branches share
  struct Segment;  // a summary in the making
  class Iteration;

  // branching.cpp
  /// What a PathEnd that is caught has to go back to.
  struct Checkpoint {
    std::size_t region;
    Activation* activation;
    Loop* loop;
    std::uint32_t depth;
    std::size_t facts;
  };
  Checkpoint checkpoint() const;
  void unwind(const Checkpoint& checkpoint);
  State fork_state(std::span<const Slot> assigned) const;
  void restore(const State& state, std::span<const Slot> assigned);
  bool join(std::span<const NodeId> guards, std::vector<std::optional<State>>& ends, const State& before,
            std::span<const Slot> assigned, Value& value);
  void enter_side(const Site& site, BranchSide::Kind kind, Span span);
  void note_taken(const Site& site, bool condition);
  /// The condition, or kTrue or kFalse if the path settles it.
  NodeId settle(NodeId condition) const;
  void check_condition(NodeId condition, Span span);
  void note(NodeId condition, ConstraintKind requirement, Span span, Span whole, const std::string& message,
            AddressId at);
  NodeId truth_of(const Expr& condition);
  void add_exit(Exits& exits, NodeId guard, std::span<const Slot> slots, Value value);
  void resume(Exits& exits, std::span<const Slot> slots);
  void cut(Span span);
  void check_stack(Span span);
  Diagnostic diagnose(Span span, const std::string& message, const std::string& help) const;

  // calls.cpp
  Value run_module(std::uint32_t module);
  Value call_closure(const Ref<Closure>& closure, const CallExpr& site, std::vector<Value> arguments);
  Value call_shared(const Ref<Closure>& closure, const CallExpr& site, std::vector<Value> arguments);
  Value call_builtin(const Builtin& builtin, const CallExpr& site, std::vector<Value> positional,
                     std::vector<std::pair<const Argument*, Value>> named);
  Value construct(const RecordType& type, const CallExpr& site, std::vector<Value> arguments);
  std::vector<Value> bind(const std::string& name, const std::vector<Parameter>& parameters,
                          const CallExpr& site, std::vector<Value> positional,
                          std::vector<std::pair<const Argument*, Value>> named);
  const Summary* find_summary(AddressId address, const Closure& closure, const std::vector<Value>& arguments);
  Value use_summary(const Summary& summary);
  void note_read(const Frame& frame, Slot slot, const Value& value);
  AddressId activation_address(Activation& activation);
  std::vector<std::string> call_names() const;
  Ref<Frame> make_frame(const Function& function, Ref<Frame> outer, std::vector<Value> arguments = {});
  Value run_body(Activation& activation);

  // statements.cpp
  bool statement(const Stmt& node);
  bool block(const BlockStmt& node);
  bool if_statement(const IfStmt& node);
  void assignment(const AssignStmt& node);
  bool return_statement(const ReturnStmt& node);
  bool jump(const Stmt& node);
  void param(const ParamStmt& node);

  // iteration.cpp
  bool for_statement(const ForStmt& node);
  bool while_statement(const WhileStmt& node);
  template <class Enter>
  bool run_loop(const Stmt& body, std::span<const Slot> assigned, Enter enter);
  bool turn(const Stmt& body, Loop& loop);
  bool enter_turn(NodeId more, const Site& site, Span span, Exits& ends, std::span<const Slot> assigned,
                  Value value, std::size_t region);
  void set_variables(const std::vector<LoopVariable>& variables, const Value& value, Span span);
  Value comprehension(const ComprehensionExpr& node);
  void append(Value& collected, const Value& element, Span span);
  void clause(const ComprehensionExpr& node, std::size_t number, Value& collected);
  void conditions(const ComprehensionExpr& node, std::size_t clause_number, std::size_t number,
                  Value& collected);

  // expressions.cpp
  Value expression(const Expr& node);
  Value literal(const LiteralExpr& node);
  Value name(const NameExpr& node);
  Value list(const ListExpr& node);
  Value unary_expression(const UnaryExpr& node);
  Value binary(const BinaryExpr& node);
  Value logical(const LogicalExpr& node);
  Value if_expression(const IfExpr& node);
  Value call(const CallExpr& node);
  bool assert_apart(const CallExpr& node);
  void assert_conjuncts(const Expr& condition, Span whole, const std::string& message);
  Value function(const FunctionExpr& node);
  Value read(const Frame& frame, Slot slot, const NameExpr& node);

  // elements.cpp
  using Change = std::function<void(Value&)>;
  void change(const Expr& target, const Change& change);
  void update(const Expr& target, std::span<const Value> indices, const Change& change);
  void update_element(Value& object, const Value& index, Span span, const Change& change);
  void update_field(Value& object, const FieldExpr& target, const Change& change);
  std::size_t field_position(const RecordStmt& type, const FieldExpr& access);
  Value element_of(const std::vector<Value>& items, const Value& index, Span span);
  std::pair<std::int64_t, std::int64_t> possible_indices(NodeId index, std::size_t count, Span span);
  void check_nesting(const Value& value, Span span);

  // operators.cpp
  Value arithmetic_shaped(BinaryOp op, const Value& a, const Value& b, Span span);
  Value int_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span);
  Value float_arithmetic(BinaryOp op, const Value& a, const Value& b, Span span);
  Value apply_value(Op op, const Value& a, const Value& b, Span span);
  Value equal_shaped(const Value& a, const Value& b);
  Value equal_members(const std::vector<Value>& a, const std::vector<Value>& b);
  NodeId float_node(const Value& number, Span span);

  friend class Iteration;

  const Program& program_;
  const ParamValues& params_;
  Choices& choices_;
  Branches* branches_;
  Graph& graph_;
  AddressTable& addresses_;
  TraceRecorder* recorder_;
  Limits limits_;

  Path path_;
  Activation* current_ = nullptr;
  Loop* loop_ = nullptr;
  std::uint32_t depth_ = 0;
  std::uint64_t total_steps_ = 0;
  std::uint32_t isolated_ = 0;         // above 0: in a conjunct that is looked at by itself
  std::size_t isolated_region_ = 0;    // where it began
  NodeId unknown_ = kFalse;            // since then: what the pass could not express
  const char* stack_limit_ = nullptr;  // addresses below it are too close to the stack's end
  std::uint32_t frames_made_ = 0;
  std::vector<Ref<Frame>> captured_frames_;  // cleared at the end: closures in them refer back to them
  std::vector<Ref<Frame>> module_frames_;
  std::vector<bool> module_done_;
  Execution execution_;
  std::vector<SymbolicPlacement> placements_;
  bool complete_ = true;

  std::unordered_map<AddressId, std::vector<std::unique_ptr<Summary>>> summaries_;
  std::vector<Segment*> segments_;
};

/// The variables of the running function that a part of it assigns, and the path, at a point where branches
/// fork.
struct Evaluator::State {
  std::vector<Value> slots;
  NodeId local;
  std::uint32_t levels;
  std::uint64_t steps, guarded_steps;
  std::size_t facts;
  Path::Losses losses;
  Value value;
};

template <class Part>
bool Evaluator::split(std::span<const NodeId> guards, std::span<const Slot> assigned, Value& value,
                      Part part) {
  const State before = fork_state(assigned);
  const Checkpoint start = checkpoint();
  std::vector<std::optional<State>> ends(guards.size());
  for (std::size_t i = 0; i < guards.size(); ++i) {
    restore(before, assigned);
    path_.narrow(guards[i]);
    path_.facts.assume(guards[i], true);
    Value made;
    bool goes_on = false;
    try {
      goes_on = part(i, made);
    } catch (const PathEnd&) {
      unwind(start);
    }
    if (!goes_on) continue;
    ends[i] = fork_state(assigned);
    ends[i]->value = std::move(made);
  }
  return join(guards, ends, before, assigned, value);
}

template <class Then, class Else>
bool Evaluator::branch(NodeId condition, const Site& site, Span span, std::span<const Slot> assigned,
                       Value& value, Then then_part, Else else_part) {
  condition = settle(condition);
  if (condition == kTrue || condition == kFalse) {
    note_taken(site, condition == kTrue);
    return condition == kTrue ? then_part(value) : else_part(value);
  }
  check_condition(condition, span);
  const std::array guards = {condition, graph_.negation(condition)};
  return split(guards, assigned, value, [&](std::size_t side, Value& made) {
    if (site.label != kNoLabel)
      enter_side(site, side == 0 ? BranchSide::Kind::kThen : BranchSide::Kind::kElse, span);
    return side == 0 ? then_part(made) : else_part(made);
  });
}

template <class Then, class Else>
Value Evaluator::choose_side(NodeId condition, const Site& site, Span span, std::span<const Slot> assigned,
                             Then then_value, Else else_value) {
  Value value;
  const bool goes_on = branch(
      condition, site, span, assigned, value, [&](Value& made) { return made = then_value(), true; },
      [&](Value& made) { return made = else_value(), true; });
  if (!goes_on) end_path();
  return value;
}

template <class Function>
Value Evaluator::each_shape(const Value& value, Function f) {
  const Union* several = value.as_union();
  if (several == nullptr) return f(value);
  const Value kept = value;  // the alternatives must outlive what f does to variables
  std::vector<NodeId> guards;
  for (const auto& alternative : several->alternatives) guards.push_back(alternative.guard);
  Value result;
  const bool goes_on = split(guards, {}, result, [&](std::size_t i, Value& made) {
    made = f(several->alternatives[i].value);
    return true;
  });
  if (!goes_on) end_path();
  return result;
}

}  // namespace solitaire
