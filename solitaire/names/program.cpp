#include "solitaire/names/program.h"

#include <algorithm>

namespace solitaire {
namespace {

void collect_params(const Program& program, std::uint32_t module, std::vector<bool>& seen,
                    std::vector<const ParamStmt*>& params) {
  if (seen[module]) return;
  seen[module] = true;
  for (const std::uint32_t imported : program.modules[module].imports)
    collect_params(program, imported, seen, params);
  for (const StmtPtr& statement : program.top(module).body->statements) {
    if (statement->kind == StmtKind::kParam) params.push_back(static_cast<const ParamStmt*>(statement.get()));
  }
}

}  // namespace

bool Program::is_library(const Function& function) const {
  return std::any_of(modules.begin(), modules.end(), [&](const Module& module) {
    return module.is_library && module.source == function.span.source;
  });
}

const OutputStmt* Program::output() const {
  const auto& statements = top(0).body->statements;
  const bool has_one = !statements.empty() && statements.back()->kind == StmtKind::kOutput;
  return has_one ? static_cast<const OutputStmt*>(statements.back().get()) : nullptr;
}

std::vector<const ParamStmt*> Program::params() const {
  std::vector<const ParamStmt*> params;
  std::vector<bool> seen(modules.size());
  collect_params(*this, 0, seen, params);
  return params;
}

}  // namespace solitaire
