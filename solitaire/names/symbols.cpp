#include "solitaire/names/symbols.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "solitaire/builtins/builtin.h"
#include "solitaire/syntax/tree_walker.h"

namespace solitaire {
namespace {

bool covers(Span span, std::uint32_t source, std::uint32_t offset) {
  return span.source == source && span.begin <= offset && offset <= span.end;
}

auto in_order(Span span) { return std::tuple(span.source, span.begin, span.end); }

}  // namespace

/// Walks over all modules and fills a SymbolTable.
class SymbolCollector : public TreeWalker {
 public:
  SymbolCollector(const Program& program, SymbolTable& table) : program_(program), table_(table) {}

  void run() {
    for (const Module& module : program_.modules) {
      table_.imports_.push_back(module.imports);
      modules_.push_back(make_frame(*module.tree.top, module_span(module), std::nullopt));
    }
    make_builtins();
    for (std::uint32_t number = 0; number < program_.modules.size(); ++number) {
      frames_ = {&modules_[number]};
      TreeWalker::function(*program_.modules[number].tree.top);
    }
    finish();
  }

  void function(const Function& node) override {
    Frame frame = make_frame(node, node.span, frames_.back()->scope);
    frames_.push_back(&frame);
    for (std::size_t i = 0; i < node.parameters.size(); ++i) {
      const auto slot = std::find(node.slots.begin(), node.slots.end(), node.parameters[i].name);
      define(frame.symbols[static_cast<std::size_t>(slot - node.slots.begin())], SymbolKind::kParameter,
             node.parameters[i].span);
    }
    TreeWalker::function(node);
    frames_.pop_back();
  }

  void expression(const Expr& node) override {
    if (node.kind == ExprKind::kName) return name(static_cast<const NameExpr&>(node));
    if (node.kind == ExprKind::kComprehension)
      return comprehension(static_cast<const ComprehensionExpr&>(node));
    TreeWalker::expression(node);
  }

  void statement(const Stmt& node) override {
    switch (node.kind) {
      case StmtKind::kAssign:
        define_targets(static_cast<const AssignStmt&>(node));
        break;
      case StmtKind::kFor:
        define_variables(static_cast<const ForStmt&>(node).variables);
        break;
      case StmtKind::kRecord: {
        const auto& record = static_cast<const RecordStmt&>(node);
        if (!record.name.empty()) define(local(record.slot), SymbolKind::kRecord, record.name_span);
        break;
      }
      case StmtKind::kParam: {
        const auto& param = static_cast<const ParamStmt&>(node);
        if (!param.name.empty()) define(local(param.slot), SymbolKind::kParam, param.name_span);
        break;
      }
      case StmtKind::kImport:
        import(static_cast<const ImportStmt&>(node));
        break;
      default:
        break;
    }
    TreeWalker::statement(node);
  }

 private:
  /// A function, with a symbol for each of its slots.
  struct Frame {
    std::size_t scope;  // the innermost around the node at hand
    std::vector<SymbolId> symbols;
  };

  static Span module_span(const Module& module) { return {module.source, 0, UINT32_MAX}; }

  Frame make_frame(const Function& node, Span span, std::optional<std::size_t> outer) {
    Frame frame{table_.scopes_.size(), {}};
    for (const std::string& name : node.slots) frame.symbols.push_back(make_symbol(name));
    functions_.push_back(frame.scope);
    table_.scopes_.push_back({span, outer, frame.symbols});
    return frame;
  }

  SymbolId make_symbol(std::string_view name) {
    table_.symbols_.push_back({std::string(name), SymbolKind::kVariable, std::nullopt, {}});
    return static_cast<SymbolId>(table_.symbols_.size() - 1);
  }

  void make_builtins() {
    for (const Builtin& builtin : builtins()) {
      table_.builtins_.push_back(make_symbol(builtin.name));
      table_.symbols_.back().kind = SymbolKind::kBuiltin;
    }
  }

  SymbolId local(Slot slot) const { return frames_.back()->symbols[slot]; }

  std::optional<SymbolId> symbol_of(const Binding& binding) const {
    switch (binding.kind) {
      case Binding::Kind::kUnresolved:
        return std::nullopt;
      case Binding::Kind::kLocal:
        return local(binding.slot);
      case Binding::Kind::kOuter:
        return frames_[frames_.size() - 1 - binding.level]->symbols[binding.slot];
      case Binding::Kind::kModule:
        return modules_[binding.level].symbols[binding.slot];
      case Binding::Kind::kBuiltin:
        return table_.builtins_[binding.level];
    }
    return std::nullopt;
  }

  void use(SymbolId symbol, Span span) { table_.uses_.push_back({span, symbol}); }

  void define(SymbolId symbol, SymbolKind kind, Span span) {
    SymbolInfo& made = table_.symbols_[symbol];
    if (!made.definition) {
      made.definition = span;
      made.kind = kind;
    }
    use(symbol, span);
  }

  void name(const NameExpr& node) {
    if (const auto symbol = symbol_of(node.binding)) use(*symbol, node.span);
  }

  /// The walk goes on to the targets and adds them as uses; here they only become definitions.
  void define_targets(const AssignStmt& node) {
    for (const ExprPtr& target : node.targets) {
      if (target->kind != ExprKind::kName) continue;
      const auto symbol = symbol_of(static_cast<const NameExpr&>(*target).binding);
      if (!symbol || table_.symbols_[*symbol].definition) continue;
      table_.symbols_[*symbol].definition = target->span;
      if (node.declares_function) table_.symbols_[*symbol].kind = SymbolKind::kFunction;
    }
  }

  void define_variables(const std::vector<LoopVariable>& variables) {
    for (const LoopVariable& variable : variables)
      define(local(variable.slot), SymbolKind::kVariable, variable.span);
  }

  /// The variables of a comprehension can be named in it alone.
  void comprehension(const ComprehensionExpr& node) {
    const std::size_t outer = frames_.back()->scope;
    frames_.back()->scope = table_.scopes_.size();
    table_.scopes_.push_back({node.span, outer, {}});
    for (const ComprehensionClause& clause : node.clauses) {
      define_variables(clause.variables);
      for (const LoopVariable& variable : clause.variables) {
        table_.scopes_.back().symbols.push_back(local(variable.slot));
        in_comprehensions_.insert(local(variable.slot));
      }
    }
    TreeWalker::expression(node);
    frames_.back()->scope = outer;
  }

  void import(const ImportStmt& node) {
    if (node.module == ImportStmt::kNoModule) return;
    const Module& module = program_.modules[node.module];
    const SymbolId symbol = make_symbol(node.path);
    define(symbol, SymbolKind::kFile, node.path_span);
    table_.symbols_[symbol].definition = Span{module.source, 0, 0};
  }

  void finish() {
    for (const std::size_t scope : functions_) {
      std::erase_if(table_.scopes_[scope].symbols,
                    [&](SymbolId symbol) { return in_comprehensions_.count(symbol) > 0; });
    }
    std::sort(table_.uses_.begin(), table_.uses_.end(),
              [](const auto& a, const auto& b) { return in_order(a.span) < in_order(b.span); });
    for (const auto& use : table_.uses_) table_.symbols_[use.symbol].uses.push_back(use.span);
  }

  const Program& program_;
  SymbolTable& table_;
  std::vector<Frame> modules_;          // by module
  std::vector<Frame*> frames_;          // of the functions around the node at hand, innermost last
  std::vector<std::size_t> functions_;  // their scopes
  std::unordered_set<SymbolId> in_comprehensions_;
};

SymbolTable::SymbolTable(const Program& program) { SymbolCollector(program, *this).run(); }

std::optional<SymbolId> SymbolTable::symbol_at(std::uint32_t source, std::uint32_t offset) const {
  // The uses do not overlap, so that the last one that starts at the offset or before it is the only one.
  const auto after = std::upper_bound(
      uses_.begin(), uses_.end(), std::pair(source, offset),
      [](const auto& place, const Use& use) { return place < std::pair(use.span.source, use.span.begin); });
  if (after == uses_.begin() || !covers((after - 1)->span, source, offset)) return std::nullopt;
  return (after - 1)->symbol;
}

std::optional<Span> SymbolTable::definition_at(std::uint32_t source, std::uint32_t offset) const {
  const auto symbol = symbol_at(source, offset);
  return symbol ? symbols_[*symbol].definition : std::nullopt;
}

std::vector<SymbolId> SymbolTable::names_in_scope_at(std::uint32_t source, std::uint32_t offset) const {
  std::vector<SymbolId> found;
  std::set<std::string_view> names;
  const auto add = [&](const std::vector<SymbolId>& symbols) {
    for (const SymbolId symbol : symbols) {
      if (names.insert(symbols_[symbol].name).second) found.push_back(symbol);
    }
  };
  // Inner scopes stand behind outer ones, so that the last that covers the offset is the innermost.
  const auto innermost = std::find_if(scopes_.rbegin(), scopes_.rend(),
                                      [&](const Scope& scope) { return covers(scope.span, source, offset); });
  if (innermost == scopes_.rend()) return found;
  const Scope* scope = &*innermost;
  for (; scope->outer; scope = &scopes_[*scope->outer]) add(scope->symbols);
  add(scope->symbols);
  const std::vector<std::uint32_t>& imports = imports_[static_cast<std::size_t>(scope - scopes_.data())];
  for (auto module = imports.rbegin(); module != imports.rend(); ++module) add(scopes_[*module].symbols);
  add(builtins_);
  return found;
}

}  // namespace solitaire
