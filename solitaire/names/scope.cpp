#include "solitaire/names/scope.h"

#include <algorithm>

namespace solitaire {

void AssignedSlots::add(Slot slot) {
  for (std::vector<Slot>* collector : collectors_) {
    if (std::find(collector->begin(), collector->end(), slot) == collector->end()) collector->push_back(slot);
  }
}

Slot Scope::add_slot(const std::string& name, Span place) {
  const auto slot = static_cast<Slot>(function.slots.size());
  function.slots.push_back(name);
  definitions.push_back(place);
  return slot;
}

Slot Scope::declare(const std::string& name, Span place) {
  const auto it = names.find(name);
  return it != names.end() ? it->second : names[name] = add_slot(name, place);
}

Slot Scope::declare_inner(const std::string& name, Span place) {
  const Slot slot = add_slot(name, place);
  inner.emplace_back(name, slot);
  return slot;
}

std::optional<Slot> Scope::find(const std::string& name) const {
  const auto shadow =
      std::find_if(inner.rbegin(), inner.rend(), [&](const auto& entry) { return entry.first == name; });
  if (shadow != inner.rend()) return shadow->second;
  const auto it = names.find(name);
  return it == names.end() ? std::nullopt : std::optional(it->second);
}

namespace {

/// `x += 1` needs a value to start from, so it declares nothing.
void declare_targets(const AssignStmt& node, Scope& scope) {
  if (node.op) return;
  for (const ExprPtr& target : node.targets) {
    if (target->kind == ExprKind::kName)
      scope.declare(static_cast<const NameExpr&>(*target).name, target->span);
  }
}

void declare_record(const RecordStmt& node, Scope& scope) {
  if (node.name.empty()) return;
  scope.declare(node.name, node.name_span);
  scope.records[node.name] = &node;
}

}  // namespace

void declare_assigned(const Stmt& body, Scope& scope) {
  switch (body.kind) {
    case StmtKind::kAssign:
      return declare_targets(static_cast<const AssignStmt&>(body), scope);
    case StmtKind::kBlock:
      for (const StmtPtr& statement : static_cast<const BlockStmt&>(body).statements)
        declare_assigned(*statement, scope);
      return;
    case StmtKind::kIf: {
      const auto& branch = static_cast<const IfStmt&>(body);
      declare_assigned(*branch.then_body, scope);
      if (branch.else_body) declare_assigned(*branch.else_body, scope);
      return;
    }
    case StmtKind::kFor: {
      const auto& loop = static_cast<const ForStmt&>(body);
      for (const LoopVariable& variable : loop.variables) scope.declare(variable.name, variable.span);
      return declare_assigned(*loop.body, scope);
    }
    case StmtKind::kWhile:
      return declare_assigned(*static_cast<const WhileStmt&>(body).body, scope);
    case StmtKind::kOutput:
      return declare_assigned(*static_cast<const OutputStmt&>(body).body, scope);
    case StmtKind::kAuxiliary:
      return declare_assigned(*static_cast<const AuxiliaryStmt&>(body).body, scope);
    case StmtKind::kRecord:
      return declare_record(static_cast<const RecordStmt&>(body), scope);
    case StmtKind::kParam: {
      const auto& param = static_cast<const ParamStmt&>(body);
      if (!param.name.empty()) scope.declare(param.name, param.name_span);
      return;
    }
    default:
      return;
  }
}

}  // namespace solitaire
