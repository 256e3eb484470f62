#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "solitaire/run/operands.h"

namespace solitaire {

/// The layer of the walk that makes calls: of functions of the program, of records' constructors and of
/// builtins.
class Calls : public Operands {
 protected:
  using Operands::Operands;

  /// Runs the top level of a file.
  Value run_module(std::uint32_t module);
  Value call(const CallExpr& node);
  /// A call with arguments that are evaluated already. `site` is where it stands.
  Value call_function(const Value& callee, const CallExpr& site, std::vector<Value> arguments) {
    return call_value(callee, site, std::move(arguments), {});
  }
  /// Runs statements at the end of the script, on the one path of an execution; `at_end` is the value where
  /// they return none.
  Value run_at_end(const BlockStmt& body, Value at_end);
  /// The variables that have to be kept where paths leave the function, for closures that refer to them. The
  /// list holds until the next call.
  std::span<const Slot> slots_kept(const Activation& activation);

 private:
  using NamedValues = std::vector<std::pair<const Argument*, Value>>;

  Value call_with_names(const Value& callee, const CallExpr& site);
  Value call_value(const Value& callee, const CallExpr& site, std::vector<Value> positional,
                   NamedValues named);
  void evaluate_arguments(const CallExpr& site, Value* places);
  std::vector<Value> bind(const std::string& name, const std::vector<Parameter>& parameters,
                          const CallExpr& site, std::vector<Value> positional, NamedValues named);

  Value call_closure(const Closure& closure, const CallExpr& site);
  Value call_closure(const Closure& closure, const CallExpr& site, std::vector<Value> arguments);
  void set_defaults(Activation& activation, std::size_t first, std::size_t end);
  Activation top_level(std::uint32_t module);
  Value run_body(Activation& activation);
  void begin(Activation& activation);
  bool run_statements(const Activation& activation);
  Value run_path(Activation& activation);
  Value run_paths(Activation& activation);

  Value construct(const RecordType& type, const CallExpr& site, std::vector<Value> arguments);

  Value call_builtin(const Builtin& builtin, const CallExpr& site);
  Value call_builtin(const Builtin& builtin, const CallExpr& site, std::vector<Value> positional,
                     NamedValues named);
  void check_required(const Builtin& builtin, const CallExpr& site, std::span<const Value> arguments);
  [[noreturn]] void too_many_arguments(const Builtin& builtin, const CallExpr& site, std::size_t given);

  bool assert_apart(const CallExpr& node);
  void assert_conjuncts(const Expr& condition, Span whole, const std::string& message);
};

}  // namespace solitaire
