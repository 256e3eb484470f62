#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "base/span.h"
#include "solitaire/syntax/token.h"

// The syntax tree. Every node has its exact span; tokens and comments are kept beside the tree. What the
// resolver finds out about a node (slots, labels) stands in the node's last members, each named in
// resolver.h.

namespace solitaire {

struct Expr;
struct Stmt;
struct Function;
using ExprPtr = std::unique_ptr<Expr>;
using StmtPtr = std::unique_ptr<Stmt>;

/// The number of a variable in its function's frame.
using Slot = std::uint32_t;

/// Says which variable or builtin a name stands for.
struct Binding {
  enum class Kind : std::uint8_t { kUnresolved, kLocal, kOuter, kModule, kBuiltin };
  Kind kind = Kind::kUnresolved;
  std::uint32_t level = 0;  // kOuter: how many functions out; kModule: which module; kBuiltin: which builtin
  Slot slot = 0;
};

/// The number of a label; Program::labels has the text.
using LabelId = std::uint32_t;
/// The label of a branch between expressions so plain that nothing is gained by not looking into them. Its
/// text is empty.
constexpr LabelId kNoLabel = 0;

/// A call, choice or branch site: the step that it adds to addresses. Sites of one function that can happen
/// in the same execution have different labels; sites in exclusive branches share theirs.
struct Site {
  LabelId label = kNoLabel;
  bool shared = false;  // true if an exclusive branch has a site of the same label
};

enum class ExprKind : std::uint8_t {
  kLiteral,
  kName,
  kList,
  kUnary,
  kBinary,
  kLogical,
  kCall,
  kIndex,
  kField,
  kIf,
  kFunction,
  kComprehension,
  kError
};

struct Expr {
  Expr(ExprKind which, Span where) : kind(which), span(where) {}
  virtual ~Expr() = default;
  Expr(const Expr&) = delete;
  Expr& operator=(const Expr&) = delete;

  ExprKind kind;
  Span span;
  Span parentheses = {};  // of the outermost ( ) around the expression; empty if there are none
  int height = 1;         // of the tree below; bounded, so that walking it cannot exhaust the stack
};

struct LiteralExpr : Expr {
  using Constant = std::variant<std::monostate, bool, std::int64_t, double, std::string>;
  LiteralExpr(Span where, Constant constant) : Expr(ExprKind::kLiteral, where), value(std::move(constant)) {}
  Constant value;  // monostate is nil
};

struct NameExpr : Expr {
  NameExpr(Span where, std::string text) : Expr(ExprKind::kName, where), name(std::move(text)) {}
  std::string name;
  Binding binding;
};

struct ListExpr : Expr {
  explicit ListExpr(Span where) : Expr(ExprKind::kList, where) {}
  std::vector<ExprPtr> items;
};

enum class UnaryOp : std::uint8_t { kNegate, kNot };

struct UnaryExpr : Expr {
  UnaryExpr(Span where, UnaryOp which) : Expr(ExprKind::kUnary, where), op(which) {}
  UnaryOp op;
  ExprPtr operand;
};

enum class BinaryOp : std::uint8_t {
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kModulo,
  kEqual,
  kNotEqual,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
  kUpTo,
  kIn  // an element of a list; `not in` is the negation of it
};

struct BinaryExpr : Expr {
  BinaryExpr(Span where, BinaryOp which, Span operator_span)
      : Expr(ExprKind::kBinary, where), op(which), op_span(operator_span) {}
  BinaryOp op;
  Span op_span;
  ExprPtr left, right;
};

/// `and`, `or`: the right side runs only if the left one does not settle the matter.
struct LogicalExpr : Expr {
  LogicalExpr(Span where, bool conjunction, Span operator_span)
      : Expr(ExprKind::kLogical, where), is_and(conjunction), op_span(operator_span) {}
  bool is_and;
  Span op_span;
  ExprPtr left, right;
  bool computes = false;  // the right side does nothing else
  Site site;
  std::vector<Slot> assigned;  // see ComprehensionExpr; of the right side
};

struct Argument {
  std::string name;  // "" if given by position
  Span name_span;
  ExprPtr value;
};

struct CallExpr : Expr {
  explicit CallExpr(Span where) : Expr(ExprKind::kCall, where) {}
  ExprPtr callee;
  std::vector<Argument> arguments;
  Site site;
  bool by_position = false;  // true if no argument is named
};

struct IndexExpr : Expr {
  explicit IndexExpr(Span where) : Expr(ExprKind::kIndex, where) {}
  ExprPtr object, index;
};

struct FieldExpr : Expr {
  explicit FieldExpr(Span where) : Expr(ExprKind::kField, where) {}
  ExprPtr object;
  std::string field;
  Span field_span;
  std::uint32_t number = 0;  // the number of the name in Program::field_names
};

struct IfExpr : Expr {
  explicit IfExpr(Span where) : Expr(ExprKind::kIf, where) {}
  ExprPtr condition, then_value, else_value;
  bool computes = false;  // both sides do nothing else
  Site site;
  std::vector<Slot> assigned;  // see ComprehensionExpr; of either side
};

struct FunctionExpr : Expr {
  explicit FunctionExpr(Span where);
  ~FunctionExpr() override;
  std::unique_ptr<Function> function;
};

/// A variable that a loop or a comprehension sets in each turn.
struct LoopVariable {
  std::string name;
  Span span;
  Slot slot = 0;
};

/// `for x, y in list if condition if condition`
struct ComprehensionClause {
  std::vector<LoopVariable> variables;
  ExprPtr list;
  std::vector<ExprPtr> conditions;
  Span span;
  Site site;                          // of the loop, for turns of a length that is not decided
  std::vector<Site> condition_sites;  // one for each condition
};

struct ComprehensionExpr : Expr {
  explicit ComprehensionExpr(Span where) : Expr(ExprKind::kComprehension, where) {}
  ExprPtr element;
  std::vector<ComprehensionClause> clauses;  // at least one
  std::vector<Slot> assigned;  // the variables that inner functions read, as they may do so later
};

/// Stands where an expression is missing or could not be read; only in trees that come with errors.
struct ErrorExpr : Expr {
  explicit ErrorExpr(Span where) : Expr(ExprKind::kError, where) {}
};

enum class StmtKind : std::uint8_t {
  kAssign,
  kExpr,
  kIf,
  kFor,
  kWhile,
  kBreak,
  kContinue,
  kReturn,
  kBlock,
  kRecord,
  kParam,
  kImport,
  kOutput,
  kAuxiliary,
  kError
};

struct Stmt {
  Stmt(StmtKind which, Span where) : kind(which), span(where) {}
  virtual ~Stmt() = default;
  Stmt(const Stmt&) = delete;
  Stmt& operator=(const Stmt&) = delete;

  StmtKind kind;
  Span span;
};

/// `a, b = x, y;` and `t.x += 1;`. A function `fun f() { ... }` is an assignment with declares_function.
struct AssignStmt : Stmt {
  explicit AssignStmt(Span where) : Stmt(StmtKind::kAssign, where) {}
  std::vector<ExprPtr> targets;  // names, indices and fields of names
  std::optional<BinaryOp> op;    // set for += and the like, which have one target and one value
  Span op_span;
  std::vector<ExprPtr> values;  // as many as targets, or one
  bool declares_function = false;
};

struct ExprStmt : Stmt {
  explicit ExprStmt(Span where) : Stmt(StmtKind::kExpr, where) {}
  ExprPtr value;
};

struct IfStmt : Stmt {
  explicit IfStmt(Span where) : Stmt(StmtKind::kIf, where) {}
  ExprPtr condition;
  StmtPtr then_body, else_body;  // else_body may be null
  bool weighs = false;           // both sides do nothing but weigh executions
  Site site;
  std::vector<Slot> assigned;  // by either side
};

struct ForStmt : Stmt {
  explicit ForStmt(Span where) : Stmt(StmtKind::kFor, where) {}
  std::vector<LoopVariable> variables;
  ExprPtr list;
  StmtPtr body;
  Site site;
  std::vector<Slot> assigned;
};

struct WhileStmt : Stmt {
  explicit WhileStmt(Span where) : Stmt(StmtKind::kWhile, where) {}
  ExprPtr condition;
  StmtPtr body;
  Site site;
  std::vector<Slot> assigned;
};

struct JumpStmt : Stmt {
  using Stmt::Stmt;  // kBreak or kContinue
};

struct ReturnStmt : Stmt {
  explicit ReturnStmt(Span where) : Stmt(StmtKind::kReturn, where) {}
  std::vector<ExprPtr> values;
};

struct BlockStmt : Stmt {
  explicit BlockStmt(Span where) : Stmt(StmtKind::kBlock, where) {}
  std::vector<StmtPtr> statements;
};

struct Parameter {
  std::string name;
  Span span;
  ExprPtr default_value;  // null if the argument must be given
};

/// A function, or the top level of a file.
struct Function {
  std::string name;  // "" if it has none
  Span span;
  std::vector<Parameter> parameters;  // the first slots of the frame, in this order
  std::unique_ptr<BlockStmt> body;

  std::vector<std::string> slots;  // the variables' names
  bool captured = false;           // true if an inner function can read its variables after it returned
  std::set<std::string> steps;     // the names that its calls and choices have in addresses
};

inline FunctionExpr::FunctionExpr(Span where) : Expr(ExprKind::kFunction, where) {}
inline FunctionExpr::~FunctionExpr() = default;

/// `record Obj(kind, x, y = 0);`. The fields are also the constructor's parameters.
struct RecordStmt : Stmt {
  explicit RecordStmt(Span where) : Stmt(StmtKind::kRecord, where) {}
  static constexpr std::uint32_t kNoField = UINT32_MAX;
  /// Which field has the name of that number in Program::field_names, or kNoField.
  std::uint32_t position(std::uint32_t name_number) const {
    return name_number < positions.size() ? positions[name_number] : kNoField;
  }

  std::string name;
  Span name_span;
  std::vector<Parameter> fields;
  std::vector<std::uint32_t> positions;  // see position()
  Slot slot = 0;
};

struct ParamStmt : Stmt {
  explicit ParamStmt(Span where) : Stmt(StmtKind::kParam, where) {}
  std::string name;
  Span name_span;
  ExprPtr value;
  Slot slot = 0;
};

struct ImportStmt : Stmt {
  explicit ImportStmt(Span where) : Stmt(StmtKind::kImport, where) {}
  std::string path;
  Span path_span;
  bool is_complete = true;  // false if the file is not named
  static constexpr std::uint32_t kNoModule = UINT32_MAX;
  std::uint32_t module = kNoModule;  // kNoModule if it could not be imported
};

/// `output { ... }` at the end of a script: what is run for solutions only. The walk over the script's
/// statements passes it over.
struct OutputStmt : Stmt {
  explicit OutputStmt(Span where) : Stmt(StmtKind::kOutput, where) {}
  std::unique_ptr<BlockStmt> body;
};

/// `aux x = range(0, 9);`: a statement whose choices are auxiliary.
struct AuxiliaryStmt : Stmt {
  explicit AuxiliaryStmt(Span where) : Stmt(StmtKind::kAuxiliary, where) {}
  StmtPtr body;
};

/// Stands where a statement could not be read; only in trees that come with errors.
struct ErrorStmt : Stmt {
  explicit ErrorStmt(Span where) : Stmt(StmtKind::kError, where) {}
};

/// One file: its top level as a function without parameters, and what tools need of the text around it.
struct SyntaxTree {
  std::unique_ptr<Function> top;
  std::vector<Token> tokens;  // the last one is kEnd
  std::vector<Span> comments;
  /// The names in the stretches of text that were skipped after errors, sorted. They may have been defined
  /// there.
  std::vector<std::string> skipped_names;
};

}  // namespace solitaire
