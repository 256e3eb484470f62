#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "solitaire/names/program.h"
#include "solitaire/names/scope.h"

namespace solitaire {

/// Finds what names stand for in one module: variables of the function at hand and of those around it, then
/// names of imported files, then builtins.
class Lookup {
 public:
  Lookup(const Program& program, std::uint32_t module) : program_(program), module_(module) {}

  /// Returns the binding of a name; its kind is kUnresolved if there is none.
  Binding find(Scope& scope, const std::string& name) const;
  /// Returns where a variable of `scope` or of a scope around it is first assigned; nothing for a name of
  /// another file.
  std::optional<Span> definition(const Scope& scope, const Binding& binding) const;
  /// Reports that a name stands for nothing, unless it may be defined in what could not be read.
  void report_unknown(const Scope& scope, const NameExpr& node, Diagnostics& diagnostics) const;

 private:
  bool may_be_unread(const std::string& name) const;
  std::vector<std::string> visible_names(const Scope& scope) const;

  const Program& program_;
  std::uint32_t module_;
};

}  // namespace solitaire
