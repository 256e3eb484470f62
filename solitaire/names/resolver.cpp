#include "solitaire/names/resolver.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "solitaire/names/call_labels.h"
#include "solitaire/names/lookup.h"
#include "solitaire/names/plain.h"
#include "solitaire/names/scope.h"

namespace solitaire {
namespace {

class Resolver {
 public:
  Resolver(Program& program, std::uint32_t number, Naming naming, Diagnostics& diagnostics)
      : program_(program),
        number_(number),
        naming_(naming),
        lookup_(program, number),
        diagnostics_(diagnostics) {}

  void run() { function(*program_.modules[number_].tree.top); }

 private:
  void function(Function& made) {
    Scope scope(made, scope_, program_.labels);
    scope_ = &scope;
    for (const Parameter& parameter : made.parameters) scope.declare(parameter.name, parameter.span);
    declare_assigned(*made.body, scope);
    if (scope.outer == nullptr) program_.modules[number_].names = scope.names;
    for (const Parameter& parameter : made.parameters) {
      if (parameter.default_value) expression_for(parameter.name, *parameter.default_value);
    }
    statement(*made.body);
    label_parameter_calls();
    scope.sites.mark_shared();
    made.steps = scope.sites.names();
    scope_ = scope.outer;
  }

  void branch_site(Site& site, const char* kind, Span span) {
    const Position at = program_.sources[span.source].position(span.begin);
    const Module& module = program_.modules[number_];
    // What the library does can have the address of its caller, whose branches may stand at the same place.
    const std::string file = module.is_library ? module.path.filename().string() + ':' : "";
    scope_->sites.at_place(site, kind, fmt::format("{}{}:{}", file, at.line, at.column));
  }

  // ---- statements

  /// Returns true if control never comes to the statement's end because it returns on every path.
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
        jump(node);
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
      case StmtKind::kOutput:
        output(static_cast<OutputStmt&>(node));
        return false;
      case StmtKind::kAuxiliary:
        return statement(*static_cast<AuxiliaryStmt&>(node).body);
      case StmtKind::kError:
        return false;
    }
    return false;
  }

  bool block(BlockStmt& node) {
    bool returns = false;
    ++scope_->blocks;
    for (const StmtPtr& child : node.statements) returns = statement(*child) || returns;
    --scope_->blocks;
    return returns;
  }

  bool if_statement(IfStmt& node) {
    expression(*node.condition);
    bool then_returns = false;
    bool else_returns = false;
    scope_->assigned.collect(node.assigned, [&] {
      scope_->sites.exclusive([&] { return then_returns = statement(*node.then_body); },
                              [&] { return else_returns = node.else_body && statement(*node.else_body); });
    });
    const bool plain = is_plain(*node.then_body) && (!node.else_body || is_plain(*node.else_body));
    if (!plain) branch_site(node.site, "if", node.span);
    return then_returns && else_returns;
  }

  void for_statement(ForStmt& node) {
    branch_site(node.site, "for", node.span);
    expression(*node.list);
    scope_->assigned.collect(node.assigned, [&] {
      for (LoopVariable& variable : node.variables) {
        variable.slot = scope_->declare(variable.name, variable.span);
        scope_->assigned.add(variable.slot);
      }
      loop_body(*node.body);
    });
  }

  void while_statement(WhileStmt& node) {
    branch_site(node.site, "while", node.span);
    scope_->assigned.collect(node.assigned, [&] {
      expression(*node.condition);
      loop_body(*node.body);
    });
  }

  void loop_body(Stmt& body) {
    ++scope_->loops;
    statement(body);
    --scope_->loops;
  }

  void jump(const Stmt& node) {
    if (scope_->loops > 0) return;
    diagnostics_.add(
        "jump-outside-loop", node.span,
        fmt::format("there is no loop around this {}", node.kind == StmtKind::kBreak ? "break" : "continue"));
  }

  void return_statement(ReturnStmt& node) {
    if (scope_->outer != nullptr && node.values.size() == 1)
      collect_results(*node.values.front(), scope_->results);
    for (const ExprPtr& value : node.values) expression(*value);
    if (scope_->outer == nullptr && number_ != 0) {
      diagnostics_.add("return-in-import", node.span, "an imported file returns nothing",
                       "a return stands in a function or in the script itself");
    }
  }

  void top_level_only(Span span, const std::string& what) {
    if (scope_->outer != nullptr || scope_->blocks != 1)
      diagnostics_.add("not-at-top-level", span, what + " stands at the top level of a file");
  }

  void output(OutputStmt& node) {
    top_level_only(node.span, "an output");
    if (number_ != 0) {
      diagnostics_.add("output-in-import", node.span, "an imported file has no output",
                       "the output stands at the end of the script itself");
    } else if (scope_->outer == nullptr && scope_->blocks == 1 &&
               scope_->function.body->statements.back().get() != &node) {
      diagnostics_.add("output-not-last", node.span, "the output stands at the end of the script",
                       "move what follows it before it, or into it");
    }
    statement(*node.body);
  }

  void record(RecordStmt& node) {
    top_level_only(node.span, "a record");
    for (std::uint32_t i = 0; i < node.fields.size(); ++i) {
      const Parameter& field = node.fields[i];
      if (field.default_value) expression_for(field.name, *field.default_value);
      const std::uint32_t number = program_.field_names.number(field.name);
      if (number >= node.positions.size()) node.positions.resize(number + 1, RecordStmt::kNoField);
      if (node.positions[number] == RecordStmt::kNoField) node.positions[number] = i;
    }
    if (node.name.empty()) return;
    node.slot = scope_->declare(node.name, node.name_span);
    scope_->assigned.add(node.slot);
  }

  void param(ParamStmt& node) {
    top_level_only(node.span, "a param");
    expression_for(node.name, *node.value);
    if (node.name.empty()) return;
    node.slot = scope_->declare(node.name, node.name_span);
    scope_->assigned.add(node.slot);
  }

  // ---- assignments

  void assign(AssignStmt& node) {
    for (std::size_t i = 0; i < node.values.size(); ++i) {
      expression_for(i < node.targets.size() ? target_name(*node.targets[i], naming_) : "", *node.values[i]);
    }
    for (const ExprPtr& target : node.targets) assign_target(*target, node.op.has_value());
  }

  /// `changes` is true where the target needs a value already.
  void assign_target(Expr& target, bool changes) {
    switch (target.kind) {
      case ExprKind::kIndex:
        assign_target(*static_cast<IndexExpr&>(target).object, true);
        return expression(*static_cast<IndexExpr&>(target).index);
      case ExprKind::kField:
        return assign_target(object_of(static_cast<FieldExpr&>(target)), true);
      case ExprKind::kName:
        return assign_name(static_cast<NameExpr&>(target), changes);
      default:
        return;
    }
  }

  void assign_name(NameExpr& node, bool changes) {
    const Binding binding = lookup_.find(*scope_, node.name);
    if (binding.kind == Binding::Kind::kLocal) {
      node.binding = binding;
      return scope_->assigned.add(binding.slot);
    }
    if (binding.kind == Binding::Kind::kUnresolved || !changes)
      return lookup_.report_unknown(*scope_, node, diagnostics_);
    Diagnostic diagnostic{
        node.span,
        fmt::format("'{}' does not belong to this function, which cannot change it", node.name),
        "return the new value and assign it where the variable belongs",
        {},
        Severity::kError,
        "foreign-variable",
        {}};
    if (const auto definition = lookup_.definition(*scope_, binding))
      diagnostic.related.push_back({*definition, fmt::format("'{}' is defined here", node.name)});
    diagnostics_.add(std::move(diagnostic));
  }

  Expr& object_of(FieldExpr& access) {
    access.number = program_.field_names.number(access.field);
    return *access.object;
  }

  // ---- expressions

  /// Resolves an expression whose choices are named after what it is for.
  void expression_for(const std::string& purpose, Expr& node) {
    std::string outer = std::exchange(scope_->purpose, purpose);
    expression(node);
    scope_->purpose = std::move(outer);
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
        scope_->function.captured = true;
        return function(*static_cast<FunctionExpr&>(node).function);
      case ExprKind::kComprehension:
        return comprehension(static_cast<ComprehensionExpr&>(node));
    }
  }

  void name(NameExpr& node) {
    node.binding = lookup_.find(*scope_, node.name);
    if (node.binding.kind == Binding::Kind::kUnresolved) lookup_.report_unknown(*scope_, node, diagnostics_);
  }

  void logical(LogicalExpr& node) {
    expression(*node.left);
    scope_->assigned.collect(node.assigned, [&] { expression(*node.right); });
    if (!is_plain(*node.right)) branch_site(node.site, node.is_and ? "and" : "or", node.op_span);
  }

  void if_expression(IfExpr& node) {
    expression(*node.condition);
    scope_->assigned.collect(node.assigned, [&] {
      scope_->sites.exclusive([&] { return expression(*node.then_value), false; },
                              [&] { return expression(*node.else_value), false; });
    });
    if (!is_plain(*node.then_value) || !is_plain(*node.else_value)) branch_site(node.site, "if", node.span);
  }

  void call(CallExpr& node) {
    expression(*node.callee);
    node.by_position =
        std::ranges::all_of(node.arguments, [](const Argument& argument) { return argument.name.empty(); });
    const std::vector<Parameter>* fields = record_fields(*node.callee);
    for (std::size_t i = 0; i < node.arguments.size(); ++i) {
      const Argument& argument = node.arguments[i];
      std::string purpose = argument.name;
      if (fields != nullptr && argument.name.empty() && i < fields->size()) purpose = (*fields)[i].name;
      const bool of_variable = naming_ != Naming::kAfterFunctions && !scope_->purpose.empty();
      if (fields != nullptr && !purpose.empty() && of_variable) purpose = scope_->purpose + '.' + purpose;
      expression_for(purpose, *argument.value);
    }
    const std::string label = call_label(program_, *node.callee, scope_->purpose, naming_);
    if (calls_parameter(*node.callee)) {
      scope_->parameter_calls.emplace_back(&node.site, label);
    } else if (!leave_out_wrapper(node)) {
      scope_->sites.count(node.site, label);
    }
  }

  /// Leaves the site of a call without a label if addresses stay apart without one, and the call is one of
  /// the library whose result the function at hand returns: all that it makes is the function's own and needs
  /// no step. Returns true if it did.
  bool leave_out_wrapper(CallExpr& node) {
    if (naming_ != Naming::kToday || !scope_->purpose.empty() || !scope_->results.contains(&node) ||
        !is_of_library(program_, *node.callee))
      return false;
    const Function* called = imported_function(program_, static_cast<const NameExpr&>(*node.callee));
    return called != nullptr && scope_->sites.leave_out(node.site, called->steps);
  }

  /// Returns true if a function of the library calls what it was given.
  bool calls_parameter(const Expr& callee) const {
    if (!program_.modules[number_].is_library || callee.kind != ExprKind::kName) return false;
    if (naming_ == Naming::kAfterFunctions) return false;
    const auto& name = static_cast<const NameExpr&>(callee);
    return name.binding.kind == Binding::Kind::kLocal &&
           name.binding.slot < scope_->function.parameters.size();
  }

  /// The only call of what a function of the library was given adds no step to addresses.
  void label_parameter_calls() {
    if (scope_->parameter_calls.size() == 1) return;
    for (const auto& [site, label] : scope_->parameter_calls) scope_->sites.count(*site, label);
  }

  /// Returns the fields of the record that a call constructs; null if it constructs none.
  const std::vector<Parameter>* record_fields(const Expr& callee) const {
    if (callee.kind != ExprKind::kName) return nullptr;
    const auto& name = static_cast<const NameExpr&>(callee);
    for (const Scope* scope = scope_; scope != nullptr; scope = scope->outer) {
      const auto it = scope->records.find(name.name);
      if (it != scope->records.end()) return &it->second->fields;
    }
    return name.binding.kind == Binding::Kind::kModule ? imported_fields(program_, name) : nullptr;
  }

  /// A comprehension's variable is set before it is read, so that only those that an inner function can still
  /// read later have to be kept on every path.
  void comprehension(ComprehensionExpr& node) {
    scope_->assigned.collect(node.assigned, [&] {
      const std::size_t shadows = scope_->inner.size();
      for (ComprehensionClause& made : node.clauses) clause(made);
      expression(*node.element);
      for (std::size_t i = shadows; i < scope_->inner.size(); ++i) {
        const Slot slot = scope_->inner[i].second;
        if (scope_->read_inside.count(slot) > 0) scope_->assigned.add(slot);
      }
      scope_->inner.resize(shadows);
    });
  }

  void clause(ComprehensionClause& node) {
    branch_site(node.site, "for", node.span);
    expression(*node.list);
    for (LoopVariable& variable : node.variables)
      variable.slot = scope_->declare_inner(variable.name, variable.span);
    node.condition_sites.resize(node.conditions.size());
    for (std::size_t i = 0; i < node.conditions.size(); ++i) {
      branch_site(node.condition_sites[i], "where", node.conditions[i]->span);
      expression(*node.conditions[i]);
    }
  }

  Program& program_;
  std::uint32_t number_;
  Naming naming_;
  Lookup lookup_;
  Diagnostics& diagnostics_;
  Scope* scope_ = nullptr;
};

}  // namespace

void resolve(Program& program, std::uint32_t module, Naming naming, Diagnostics& diagnostics) {
  Resolver(program, module, naming, diagnostics).run();
}

}  // namespace solitaire
