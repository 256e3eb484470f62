#include "engines/explain/asserts_in_text.h"

#include <algorithm>

#include "solitaire/builtins/builtin.h"
#include "solitaire/syntax/tree_walker.h"

namespace solitaire {
namespace {

class Asserts : public TreeWalker {
 public:
  void expression(const Expr& node) override {
    if (node.kind == ExprKind::kCall) add(static_cast<const CallExpr&>(node));
    TreeWalker::expression(node);
  }

  std::vector<Span> conditions;

 private:
  void add(const CallExpr& call) {
    if (call.callee->kind != ExprKind::kName || call.arguments.empty() || call.arguments.size() > 2) return;
    const Binding& callee = static_cast<const NameExpr&>(*call.callee).binding;
    if (callee.kind != Binding::Kind::kBuiltin || builtins()[callee.level].name != "assert") return;
    const bool by_position =
        std::ranges::all_of(call.arguments, [](const Argument& each) { return each.name.empty(); });
    if (by_position) conditions.push_back(call.arguments.front().value->span);
  }
};

}  // namespace

std::vector<Span> asserts_in_text(const Program& program) {
  Asserts asserts;
  asserts.function(program.top(0));
  return std::move(asserts.conditions);
}

}  // namespace solitaire
