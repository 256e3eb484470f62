#include "solitaire/names/resolver.h"

#include <fmt/format.h>
#include <map>
#include <string>

#include "solitaire/names/call_labels.h"
#include "solitaire/names/expression_resolver.h"
#include "solitaire/names/plain.h"

namespace solitaire {
namespace {

class Resolver : private ExpressionResolver {
 public:
  using ExpressionResolver::ExpressionResolver;

  void run() { function(*program_.modules[number_].tree.top); }

 private:
  // ---- statements

  bool statement(Stmt& node) override {
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
    node.weighs = weighs(*node.then_body) && (!node.else_body || weighs(*node.else_body));
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

  /// What a param is set to, and of what record a field is, must not depend on where one asks.
  void declared_once(const std::string& name, Span place) {
    const auto [it, is_new] = declared_.try_emplace(name, place);
    if (is_new || name.empty()) return;
    diagnostics_.add({place,
                      fmt::format("'{}' is declared here a second time", name),
                      "",
                      {},
                      Severity::kError,
                      "declared-twice",
                      {{it->second, "the other one is here"}}});
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
    declared_once(node.name, node.name_span);
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
    declared_once(node.name, node.name_span);
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

  std::map<std::string, Span> declared_;  // params and records
};

}  // namespace

void resolve(Program& program, std::uint32_t module, Naming naming, Diagnostics& diagnostics) {
  Resolver(program, module, naming, diagnostics).run();
}

}  // namespace solitaire
