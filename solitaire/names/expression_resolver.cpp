#include "solitaire/names/expression_resolver.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "solitaire/names/call_labels.h"
#include "solitaire/names/plain.h"

namespace solitaire {

void ExpressionResolver::function(Function& made) {
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

void ExpressionResolver::branch_site(Site& site, const char* kind, Span span) {
  const Position at = program_.sources[span.source].position(span.begin);
  const Module& module = program_.modules[number_];
  // What the library does can have the address of its caller, whose branches may stand at the same place.
  const std::string file = module.is_library ? module.path.filename().string() + ':' : "";
  scope_->sites.at_place(site, kind, fmt::format("{}{}:{}", file, at.line, at.column));
}

Expr& ExpressionResolver::object_of(FieldExpr& access) {
  access.number = program_.field_names.number(access.field);
  return *access.object;
}

// ---- expressions

void ExpressionResolver::expression_for(const std::string& purpose, Expr& node) {
  std::string outer = std::exchange(scope_->purpose, purpose);
  expression(node);
  scope_->purpose = std::move(outer);
}

void ExpressionResolver::expression(Expr& node) {
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

void ExpressionResolver::name(NameExpr& node) {
  node.binding = lookup_.find(*scope_, node.name);
  if (node.binding.kind == Binding::Kind::kUnresolved) lookup_.report_unknown(*scope_, node, diagnostics_);
}

void ExpressionResolver::logical(LogicalExpr& node) {
  expression(*node.left);
  scope_->assigned.collect(node.assigned, [&] { expression(*node.right); });
  if (!is_plain(*node.right)) branch_site(node.site, node.is_and ? "and" : "or", node.op_span);
  node.computes = computes(*node.right);
}

void ExpressionResolver::if_expression(IfExpr& node) {
  expression(*node.condition);
  scope_->assigned.collect(node.assigned, [&] {
    scope_->sites.exclusive([&] { return expression(*node.then_value), false; },
                            [&] { return expression(*node.else_value), false; });
  });
  if (!is_plain(*node.then_value) || !is_plain(*node.else_value)) branch_site(node.site, "if", node.span);
  node.computes = computes(*node.then_value) && computes(*node.else_value);
}

void ExpressionResolver::call(CallExpr& node) {
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
bool ExpressionResolver::leave_out_wrapper(CallExpr& node) {
  if (naming_ != Naming::kToday || !scope_->purpose.empty() || !scope_->results.contains(&node) ||
      !is_of_library(program_, *node.callee))
    return false;
  const Function* called = imported_function(program_, static_cast<const NameExpr&>(*node.callee));
  return called != nullptr && scope_->sites.leave_out(node.site, called->steps);
}

/// Returns true if a function of the library calls what it was given.
bool ExpressionResolver::calls_parameter(const Expr& callee) const {
  if (!program_.modules[number_].is_library || callee.kind != ExprKind::kName) return false;
  if (naming_ == Naming::kAfterFunctions) return false;
  const auto& name = static_cast<const NameExpr&>(callee);
  return name.binding.kind == Binding::Kind::kLocal && name.binding.slot < scope_->function.parameters.size();
}

/// The only call of what a function of the library was given adds no step to addresses.
void ExpressionResolver::label_parameter_calls() {
  if (scope_->parameter_calls.size() == 1) return;
  for (const auto& [site, label] : scope_->parameter_calls) scope_->sites.count(*site, label);
}

/// Returns the fields of the record that a call constructs; null if it constructs none.
const std::vector<Parameter>* ExpressionResolver::record_fields(const Expr& callee) const {
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
void ExpressionResolver::comprehension(ComprehensionExpr& node) {
  scope_->assigned.collect(node.assigned, [&] {
    const std::size_t shadows = scope_->inner.size();
    for (ComprehensionClause& made : node.clauses) clause(made);
    expression(*node.element);
    condition_sites(node);
    for (std::size_t i = shadows; i < scope_->inner.size(); ++i) {
      const Slot slot = scope_->inner[i].second;
      if (scope_->read_inside.count(slot) > 0) scope_->assigned.add(slot);
    }
    scope_->inner.resize(shadows);
  });
}

void ExpressionResolver::clause(ComprehensionClause& node) {
  branch_site(node.site, "for", node.span);
  expression(*node.list);
  for (LoopVariable& variable : node.variables)
    variable.slot = scope_->declare_inner(variable.name, variable.span);
  for (const ExprPtr& condition : node.conditions) expression(*condition);
}

/// A condition behind which nothing but plain expressions is evaluated, as in `[g for g in gs if test(g)]`,
/// is no site: to look into both of its sides costs nothing.
void ExpressionResolver::condition_sites(ComprehensionExpr& node) {
  for (ComprehensionClause& clause : node.clauses) {
    clause.condition_sites.resize(clause.conditions.size());
    bool plain = &clause == &node.clauses.back() && is_plain(*node.element);
    for (std::size_t i = clause.conditions.size(); i-- > 0;) {
      const Expr& condition = *clause.conditions[i];
      if (!plain) branch_site(clause.condition_sites[i], "where", condition.span);
      plain = plain && is_plain(condition);
    }
  }
}

}  // namespace solitaire
