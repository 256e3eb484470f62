#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "solitaire/names/lookup.h"
#include "solitaire/names/naming.h"
#include "solitaire/names/program.h"
#include "solitaire/names/scope.h"

namespace solitaire {

/// Binds the names in the expressions of one module, and gives calls and branches their sites.
class ExpressionResolver {
 public:
  ExpressionResolver(Program& program, std::uint32_t number, Naming naming, Diagnostics& diagnostics)
      : program_(program),
        number_(number),
        naming_(naming),
        lookup_(program, number),
        diagnostics_(diagnostics) {}
  virtual ~ExpressionResolver() = default;
  ExpressionResolver(const ExpressionResolver&) = delete;
  ExpressionResolver& operator=(const ExpressionResolver&) = delete;

 protected:
  /// Resolves a statement, of which functions in expressions have some. Returns true if control never comes
  /// to its end because it returns on every path.
  virtual bool statement(Stmt& node) = 0;

  void function(Function& made);
  void expression(Expr& node);
  /// Resolves an expression whose choices are named after what it is for.
  void expression_for(const std::string& purpose, Expr& node);
  void branch_site(Site& site, const char* kind, Span span);
  /// Returns the object whose field is accessed, and numbers the field.
  Expr& object_of(FieldExpr& access);

  Program& program_;
  std::uint32_t number_;
  Naming naming_;
  Lookup lookup_;
  Diagnostics& diagnostics_;
  Scope* scope_ = nullptr;

 private:
  void name(NameExpr& node);
  void logical(LogicalExpr& node);
  void if_expression(IfExpr& node);
  void call(CallExpr& node);
  bool leave_out_wrapper(CallExpr& node);
  bool calls_parameter(const Expr& callee) const;
  void label_parameter_calls();
  const std::vector<Parameter>* record_fields(const Expr& callee) const;
  void comprehension(ComprehensionExpr& node);
  void clause(ComprehensionClause& node);
  void condition_sites(ComprehensionExpr& node);
};

}  // namespace solitaire
