#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/span.h"
#include "solitaire/names/program.h"

namespace solitaire {

enum class SymbolKind : std::uint8_t { kVariable, kParameter, kFunction, kRecord, kParam, kFile, kBuiltin };

/// A variable, function, file or builtin that names stand for, and the places that name it.
struct SymbolInfo {
  std::string name;
  SymbolKind kind = SymbolKind::kVariable;
  /// The place that first gives it a value: a declaration, or the first assignment in the text. For an
  /// imported file, its start. Nothing for builtins.
  std::optional<Span> definition;
  std::vector<Span> uses;  // every place that names it, the definition too, in the order of the sources
};

using SymbolId = std::uint32_t;

/// The symbols of an analyzed program, also of one with errors: what an editor needs to go to definitions,
/// find and rename uses, and complete names. Offsets are in bytes. Fields are no symbols, as which record a
/// value is shows only when the program runs.
class SymbolTable {
 public:
  explicit SymbolTable(const Program& program);

  const SymbolInfo& operator[](SymbolId symbol) const { return symbols_[symbol]; }
  std::size_t size() const { return symbols_.size(); }

  /// Returns the symbol that is named at an offset, or just before it.
  std::optional<SymbolId> symbol_at(std::uint32_t source, std::uint32_t offset) const;
  std::optional<Span> definition_at(std::uint32_t source, std::uint32_t offset) const;
  const std::vector<Span>& uses_of(SymbolId symbol) const { return symbols_[symbol].uses; }
  /// Returns the symbols that a name at an offset could stand for, the nearest first: of the comprehensions
  /// and functions around it, of imported files, and the builtins. Those that a nearer one of the same name
  /// hides are left out.
  std::vector<SymbolId> names_in_scope_at(std::uint32_t source, std::uint32_t offset) const;

 private:
  friend class SymbolCollector;

  /// A stretch of text in which symbols can be named.
  struct Scope {
    Span span;
    std::optional<std::size_t> outer;
    std::vector<SymbolId> symbols;
  };
  struct Use {
    Span span;
    SymbolId symbol;
  };

  std::vector<SymbolInfo> symbols_;
  std::vector<Scope> scopes_;                        // outer ones first; modules have the first ones
  std::vector<Use> uses_;                            // in the order of the sources
  std::vector<std::vector<std::uint32_t>> imports_;  // by module
  std::vector<SymbolId> builtins_;
};

}  // namespace solitaire
