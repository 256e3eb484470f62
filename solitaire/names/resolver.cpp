#include "solitaire/names/resolver.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <utility>

#include "solitaire/builtins/builtin.h"

namespace solitaire {
namespace {

/// How often each site name has been used so far on any one path through a function. Exclusive branches start
/// from the same counts, so that their sites share labels; behind them the larger counts hold.
using Counts = std::map<std::string, int>;

Counts larger(const Counts& a, const Counts& b) {
  Counts result = a;
  for (const auto& [name, count] : b) result[name] = std::max(result[name], count);
  return result;
}

struct Scope {
  Function* function;
  Scope* outer;  // null at the top level of a module
  std::map<std::string, Slot> names;
  std::vector<std::pair<std::string, Slot>> inner;  // comprehension variables in force, innermost last
  std::set<Slot> read_inside;                       // variables that inner functions read
  std::map<std::string, const RecordStmt*> records;
  Counts counts;
  std::vector<Site*> sites;
  int loops = 0;

  Slot declare(const std::string& name) {
    const auto [it, added] = names.try_emplace(name, static_cast<Slot>(function->slots.size()));
    if (added) function->slots.push_back(name);
    return it->second;
  }
  std::optional<Slot> find(const std::string& name) const {
    const auto shadow =
        std::find_if(inner.rbegin(), inner.rend(), [&](const auto& entry) { return entry.first == name; });
    if (shadow != inner.rend()) return shadow->second;
    const auto it = names.find(name);
    return it == names.end() ? std::nullopt : std::optional(it->second);
  }
};

class Resolver {
 public:
  Resolver(Program& program, std::uint32_t number, Diagnostics& diagnostics)
      : program_(program), number_(number), module_(program.modules[number]), diagnostics_(diagnostics) {}

  void run() { function(*module_.tree.top, nullptr); }

 private:
  // ---- functions

  void function(Function& made, Scope* outer) {
    Scope scope{&made, outer, {}, {}, {}, {}, {}, {}, 0};
    scope_ = &scope;
    for (const Parameter& parameter : made.parameters) scope.declare(parameter.name);
    declare_all(*made.body);
    if (outer == nullptr) module_.names = scope.names;
    std::vector<std::vector<Slot>*> collectors = std::move(collectors_);
    collectors_.clear();
    for (const Parameter& parameter : made.parameters) {
      if (parameter.default_value) named_expression(*parameter.default_value, parameter.name);
    }
    statement(*made.body);
    collectors_ = std::move(collectors);
    mark_shared(scope.sites);
    scope_ = outer;
  }

  static void mark_shared(const std::vector<Site*>& sites) {
    std::map<LabelId, int> uses;
    for (const Site* site : sites) ++uses[site->label];
    for (Site* site : sites) site->shared = uses[site->label] > 1;
  }

  // ---- declarations: every name that a function assigns is its own throughout

  void declare_all(const Stmt& node) {
    switch (node.kind) {
      case StmtKind::kAssign: {
        const auto& assign = static_cast<const AssignStmt&>(node);
        if (assign.op) return;  // needs a value to start from, so it declares nothing
        for (const ExprPtr& target : assign.targets) {
          if (target->kind == ExprKind::kName) scope_->declare(static_cast<const NameExpr&>(*target).name);
        }
        return;
      }
      case StmtKind::kBlock:
        for (const StmtPtr& statement : static_cast<const BlockStmt&>(node).statements)
          declare_all(*statement);
        return;
      case StmtKind::kIf: {
        const auto& branch = static_cast<const IfStmt&>(node);
        declare_all(*branch.then_body);
        if (branch.else_body) declare_all(*branch.else_body);
        return;
      }
      case StmtKind::kFor: {
        const auto& loop = static_cast<const ForStmt&>(node);
        for (const LoopVariable& variable : loop.variables) scope_->declare(variable.name);
        declare_all(*loop.body);
        return;
      }
      case StmtKind::kWhile:
        declare_all(*static_cast<const WhileStmt&>(node).body);
        return;
      case StmtKind::kRecord: {
        const auto& record = static_cast<const RecordStmt&>(node);
        scope_->declare(record.name);
        scope_->records[record.name] = &record;
        return;
      }
      case StmtKind::kParam:
        scope_->declare(static_cast<const ParamStmt&>(node).name);
        return;
      default:
        return;
    }
  }

  // ---- names

  Binding lookup(const std::string& name) const {
    std::uint32_t level = 0;
    for (Scope* scope = scope_; scope != nullptr; scope = scope->outer, ++level) {
      const auto slot = scope->find(name);
      if (!slot) continue;
      if (level == 0) return {Binding::Kind::kLocal, 0, *slot};
      scope->read_inside.insert(*slot);
      if (scope->outer == nullptr) return {Binding::Kind::kModule, number_, *slot};
      return {Binding::Kind::kOuter, level, *slot};
    }
    // The last import of a name wins, as the last assignment does.
    for (auto module = module_.imports.rbegin(); module != module_.imports.rend(); ++module) {
      const auto& names = program_.modules[*module].names;
      const auto it = names.find(name);
      if (it != names.end()) return {Binding::Kind::kModule, *module, it->second};
    }
    if (const auto builtin = find_builtin(name)) return {Binding::Kind::kBuiltin, *builtin, 0};
    return {};
  }

  std::vector<std::string> visible_names() const {
    std::vector<std::string> names;
    for (Scope* scope = scope_; scope != nullptr; scope = scope->outer) {
      for (const auto& [name, slot] : scope->names) names.push_back(name);
      for (const auto& [name, slot] : scope->inner) names.push_back(name);
    }
    for (const std::uint32_t module : module_.imports) {
      for (const auto& [name, slot] : program_.modules[module].names) names.push_back(name);
    }
    for (const Builtin& builtin : builtins()) names.emplace_back(builtin.name);
    return names;
  }

  void report_unknown(const NameExpr& node) {
    for (const char* later : {"factor", "observe"}) {
      if (node.name != later) continue;
      diagnostics_.add(node.span,
                       fmt::format("'{}' needs a sampling engine, and there is none yet", node.name),
                       "choose among ints with range(lo, hi)");
      return;
    }
    for (const char* nothing : {"None", "null", "undefined"}) {
      if (node.name != nothing) continue;
      diagnostics_.add(node.span, fmt::format("there is no '{}' here", node.name),
                       "the value for nothing is nil");
      return;
    }
    const std::string nearest = nearest_name(node.name, visible_names());
    diagnostics_.add(node.span, fmt::format("there is no '{}' here", node.name),
                     nearest.empty() ? "" : fmt::format("did you mean '{}'?", nearest));
  }

  // ---- sites

  void count_site(Site& site, const std::string& name) {
    const int count = ++scope_->counts[name];
    site.label = program_.labels.number(count == 1 ? name : fmt::format("{}#{}", name, count));
    scope_->sites.push_back(&site);
  }

  void branch_site(Site& site, const char* kind, Span span) {
    const Position at = program_.sources[span.source].position(span.begin);
    site.label = program_.labels.number(fmt::format("{}@{}:{}", kind, at.line, at.column));
  }

  /// Runs two exclusive parts, each from the counts as they are now. A part that always returns has no say in
  /// the counts behind it.
  template <class Then, class Else>
  void exclusive(Then then_part, Else else_part) {
    const Counts before = scope_->counts;
    const bool then_returns = then_part();
    Counts after_then = std::move(scope_->counts);
    scope_->counts = before;
    const bool else_returns = else_part();
    if (then_returns) return;
    scope_->counts = else_returns ? std::move(after_then) : larger(after_then, scope_->counts);
  }

  // ---- statements

  void assign_slot(Slot slot) {
    for (std::vector<Slot>* collector : collectors_) {
      if (std::find(collector->begin(), collector->end(), slot) == collector->end())
        collector->push_back(slot);
    }
  }

  /// Whether control never comes to the statement's end because it returns on every path.
  bool statement(Stmt& node) {
    switch (node.kind) {
      case StmtKind::kAssign:
        assign(static_cast<AssignStmt&>(node));
        return false;
      case StmtKind::kExpr:
        expression(*static_cast<ExprStmt&>(node).value);
        return false;
      case StmtKind::kIf:
        return if_statement(static_cast<IfStmt&>(node));
      case StmtKind::kFor:
        for_statement(static_cast<ForStmt&>(node));
        return false;
      case StmtKind::kWhile:
        while_statement(static_cast<WhileStmt&>(node));
        return false;
      case StmtKind::kBreak:
      case StmtKind::kContinue:
        if (scope_->loops == 0) {
          diagnostics_.add(node.span, fmt::format("there is no loop around this {}",
                                                  node.kind == StmtKind::kBreak ? "break" : "continue"));
        }
        return false;
      case StmtKind::kReturn:
        return_statement(static_cast<ReturnStmt&>(node));
        return true;
      case StmtKind::kBlock:
        return block(static_cast<BlockStmt&>(node));
      case StmtKind::kRecord:
        record(static_cast<RecordStmt&>(node));
        return false;
      case StmtKind::kParam:
        param(static_cast<ParamStmt&>(node));
        return false;
      case StmtKind::kImport:
        top_level_only(node.span, "an import");
        return false;
      case StmtKind::kError:
        return false;
    }
    return false;
  }

  bool block(BlockStmt& node) {
    bool returns = false;
    ++depth_;
    for (const StmtPtr& child : node.statements) returns = statement(*child) || returns;
    --depth_;
    return returns;
  }

  void top_level_only(Span span, const std::string& what) {
    if (scope_->outer != nullptr || depth_ != 1)
      diagnostics_.add(span, what + " stands at the top level of a file");
  }

  void record(RecordStmt& node) {
    top_level_only(node.span, "a record");
    for (const Parameter& field : node.fields) {
      if (field.default_value) named_expression(*field.default_value, field.name);
      node.numbers.push_back(program_.field_names.number(field.name));
    }
    node.slot = scope_->declare(node.name);
    assign_slot(node.slot);
  }

  void param(ParamStmt& node) {
    top_level_only(node.span, "a param");
    named_expression(*node.value, node.name);
    node.slot = scope_->declare(node.name);
    assign_slot(node.slot);
  }

  void return_statement(ReturnStmt& node) {
    for (const ExprPtr& value : node.values) expression(*value);
    if (scope_->outer == nullptr && number_ != 0) {
      diagnostics_.add(node.span, "an imported file returns nothing",
                       "a return stands in a function or in the script itself");
    }
  }

  void assign(AssignStmt& node) {
    for (std::size_t i = 0; i < node.values.size(); ++i) {
      named_expression(*node.values[i], i < node.targets.size() ? target_name(*node.targets[i]) : "");
    }
    for (const ExprPtr& target : node.targets) assign_target(*target, node.op.has_value());
  }

  static std::string target_name(const Expr& target) {
    switch (target.kind) {
      case ExprKind::kName:
        return static_cast<const NameExpr&>(target).name;
      case ExprKind::kField:
        return static_cast<const FieldExpr&>(target).field;
      case ExprKind::kIndex:
        return target_name(*static_cast<const IndexExpr&>(target).object);
      default:
        return "";
    }
  }

  Expr& object_of(FieldExpr& access) {
    access.number = program_.field_names.number(access.field);
    return *access.object;
  }

  void assign_target(Expr& target, bool changes) {
    switch (target.kind) {
      case ExprKind::kIndex:
        expression(*static_cast<IndexExpr&>(target).index);
        return assign_target(*static_cast<IndexExpr&>(target).object, true);
      case ExprKind::kField:
        return assign_target(object_of(static_cast<FieldExpr&>(target)), true);
      case ExprKind::kName:
        return assign_name(static_cast<NameExpr&>(target), changes);
      default:
        return;
    }
  }

  void assign_name(NameExpr& node, bool changes) {
    const Binding binding = lookup(node.name);
    if (binding.kind == Binding::Kind::kLocal) {
      node.binding = binding;
      return assign_slot(binding.slot);
    }
    if (binding.kind == Binding::Kind::kUnresolved || !changes) return report_unknown(node);
    diagnostics_.add(node.span,
                     fmt::format("'{}' does not belong to this function, which cannot change it", node.name),
                     "return the new value and assign it where the variable belongs");
  }

  bool if_statement(IfStmt& node) {
    branch_site(node.site, "if", node.span);
    expression(*node.condition);
    bool then_returns = false;
    bool else_returns = false;
    collecting(node.assigned, [&] {
      exclusive([&] { return then_returns = statement(*node.then_body); },
                [&] { return else_returns = node.else_body && statement(*node.else_body); });
    });
    return then_returns && else_returns;
  }

  template <class Body>
  void collecting(std::vector<Slot>& assigned, Body body) {
    collectors_.push_back(&assigned);
    body();
    collectors_.pop_back();
  }

  void for_statement(ForStmt& node) {
    branch_site(node.site, "for", node.span);
    expression(*node.list);
    collecting(node.assigned, [&] {
      for (LoopVariable& variable : node.variables) {
        variable.slot = scope_->declare(variable.name);
        assign_slot(variable.slot);
      }
      ++scope_->loops;
      statement(*node.body);
      --scope_->loops;
    });
  }

  void while_statement(WhileStmt& node) {
    branch_site(node.site, "while", node.span);
    collecting(node.assigned, [&] {
      expression(*node.condition);
      ++scope_->loops;
      statement(*node.body);
      --scope_->loops;
    });
  }

  // ---- expressions

  /// An expression whose choices are named after what it is for.
  void named_expression(Expr& node, const std::string& name) {
    std::string outer_name = std::exchange(purpose_, name);
    expression(node);
    purpose_ = std::move(outer_name);
  }

  void expression(Expr& node) {
    switch (node.kind) {
      case ExprKind::kLiteral:
      case ExprKind::kError:
        return;
      case ExprKind::kName:
        return name(static_cast<NameExpr&>(node));
      case ExprKind::kList:
        for (const ExprPtr& item : static_cast<ListExpr&>(node).items) expression(*item);
        return;
      case ExprKind::kUnary:
        return expression(*static_cast<UnaryExpr&>(node).operand);
      case ExprKind::kBinary:
        expression(*static_cast<BinaryExpr&>(node).left);
        return expression(*static_cast<BinaryExpr&>(node).right);
      case ExprKind::kLogical:
        return logical(static_cast<LogicalExpr&>(node));
      case ExprKind::kCall:
        return call(static_cast<CallExpr&>(node));
      case ExprKind::kIndex:
        expression(*static_cast<IndexExpr&>(node).object);
        return expression(*static_cast<IndexExpr&>(node).index);
      case ExprKind::kField:
        return expression(object_of(static_cast<FieldExpr&>(node)));
      case ExprKind::kIf:
        return if_expression(static_cast<IfExpr&>(node));
      case ExprKind::kFunction:
        return inner_function(static_cast<FunctionExpr&>(node));
      case ExprKind::kComprehension:
        return comprehension(static_cast<ComprehensionExpr&>(node));
    }
  }

  void name(NameExpr& node) {
    node.binding = lookup(node.name);
    if (node.binding.kind == Binding::Kind::kUnresolved) report_unknown(node);
  }

  /// Whether the expression is free of calls and loops: evaluating it always ends at once.
  static bool is_plain(const Expr& node) {
    switch (node.kind) {
      case ExprKind::kLiteral:
      case ExprKind::kName:
        return true;
      case ExprKind::kUnary:
        return is_plain(*static_cast<const UnaryExpr&>(node).operand);
      case ExprKind::kBinary: {
        const auto& binary = static_cast<const BinaryExpr&>(node);
        return binary.op != BinaryOp::kUpTo && is_plain(*binary.left) && is_plain(*binary.right);
      }
      case ExprKind::kLogical: {
        const auto& logical = static_cast<const LogicalExpr&>(node);
        return is_plain(*logical.left) && is_plain(*logical.right);
      }
      case ExprKind::kField:
        return is_plain(*static_cast<const FieldExpr&>(node).object);
      case ExprKind::kIndex: {
        const auto& index = static_cast<const IndexExpr&>(node);
        return is_plain(*index.object) && is_plain(*index.index);
      }
      default:
        return false;
    }
  }

  void logical(LogicalExpr& node) {
    if (!is_plain(*node.right)) branch_site(node.site, node.is_and ? "and" : "or", node.op_span);
    expression(*node.left);
    collecting(node.assigned, [&] { expression(*node.right); });
  }

  void if_expression(IfExpr& node) {
    const bool plain = is_plain(*node.then_value) && is_plain(*node.else_value);
    if (!plain) branch_site(node.site, "if", node.span);
    expression(*node.condition);
    collecting(node.assigned, [&] {
      exclusive([&] { return expression(*node.then_value), false; },
                [&] { return expression(*node.else_value), false; });
    });
  }

  void inner_function(FunctionExpr& node) {
    Scope* outer = scope_;
    std::string purpose = std::exchange(purpose_, "");
    const int depth = std::exchange(depth_, 0);
    outer->function->captured = true;
    function(*node.function, outer);
    scope_ = outer;
    depth_ = depth;
    purpose_ = std::move(purpose);
  }

  void call(CallExpr& node) {
    expression(*node.callee);
    const std::vector<Parameter>* fields = record_fields(*node.callee);
    std::size_t position = 0;
    const std::string purpose = purpose_;
    for (const Argument& argument : node.arguments) {
      std::string name = argument.name;
      if (name.empty() && fields != nullptr && position < fields->size()) name = (*fields)[position].name;
      named_expression(*argument.value, name);
      ++position;
    }
    count_site(node.site, call_label(*node.callee, purpose));
  }

  const std::vector<Parameter>* record_fields(const Expr& callee) const {
    if (callee.kind != ExprKind::kName) return nullptr;
    const auto& name = static_cast<const NameExpr&>(callee);
    for (Scope* scope = scope_; scope != nullptr; scope = scope->outer) {
      const auto it = scope->records.find(name.name);
      if (it != scope->records.end()) return &it->second->fields;
    }
    return name.binding.kind == Binding::Kind::kModule ? imported_fields(name) : nullptr;
  }

  const std::vector<Parameter>* imported_fields(const NameExpr& name) const {
    for (const StmtPtr& statement : program_.modules[name.binding.level].tree.top->body->statements) {
      if (statement->kind != StmtKind::kRecord) continue;
      const auto& record = static_cast<const RecordStmt&>(*statement);
      if (record.name == name.name) return &record.fields;
    }
    return nullptr;
  }

  static std::string call_label(const Expr& callee, const std::string& purpose) {
    if (callee.kind == ExprKind::kField) return static_cast<const FieldExpr&>(callee).field;
    if (callee.kind != ExprKind::kName) return "call";
    const auto& name = static_cast<const NameExpr&>(callee);
    const bool choice =
        name.binding.kind == Binding::Kind::kBuiltin && builtins()[name.binding.level].is_choice;
    return choice && !purpose.empty() ? purpose : name.name;
  }

  /// A comprehension's variable is set before it is read, so that only those that an inner function can still
  /// read later have to be kept on every path.
  void comprehension(ComprehensionExpr& node) {
    collecting(node.assigned, [&] {
      const std::size_t shadows = scope_->inner.size();
      clauses(node);
      for (std::size_t i = shadows; i < scope_->inner.size(); ++i) {
        const Slot slot = scope_->inner[i].second;
        if (scope_->read_inside.count(slot) > 0) assign_slot(slot);
      }
      scope_->inner.resize(shadows);
    });
  }

  void clauses(ComprehensionExpr& node) {
    for (ComprehensionClause& clause : node.clauses) {
      branch_site(clause.site, "for", clause.span);
      expression(*clause.list);
      for (LoopVariable& variable : clause.variables) {
        variable.slot = static_cast<Slot>(scope_->function->slots.size());
        scope_->function->slots.push_back(variable.name);
        scope_->inner.emplace_back(variable.name, variable.slot);
      }
      clause.condition_sites.resize(clause.conditions.size());
      for (std::size_t i = 0; i < clause.conditions.size(); ++i) {
        branch_site(clause.condition_sites[i], "where", clause.conditions[i]->span);
        expression(*clause.conditions[i]);
      }
    }
    expression(*node.element);
  }

  Program& program_;
  std::uint32_t number_;
  Module& module_;
  Diagnostics& diagnostics_;
  Scope* scope_ = nullptr;
  std::vector<std::vector<Slot>*> collectors_;
  std::string purpose_;  // what the expression at hand is assigned to or passed as
  int depth_ = 0;        // of blocks in the current function
};

}  // namespace

void resolve(Program& program, std::uint32_t module, Diagnostics& diagnostics) {
  Resolver(program, module, diagnostics).run();
}

}  // namespace solitaire
