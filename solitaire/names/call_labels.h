#pragma once
#include <set>
#include <string>
#include <vector>

#include "solitaire/names/naming.h"
#include "solitaire/names/program.h"
#include "solitaire/syntax/syntax.h"

namespace solitaire {

// What calls add to addresses. All of it is for expressions whose names are resolved.

/// Returns the name of the variable, or of its field, that an assignment's target changes: "desk.x", or "x"
/// with Naming::kAfterFunctions.
std::string target_name(const Expr& target, Naming naming = Naming::kToday);
/// Returns what a call adds to addresses. Choices, and what the library makes, are named after what they are
/// for, where that is known; else `purpose` is empty.
std::string call_label(const Program& program, const Expr& callee, const std::string& purpose, Naming naming);
/// Returns true for a name that an import of a file of the library brought.
bool is_of_library(const Program& program, const Expr& callee);
/// Returns the function that another file defines under a name; null if it defines none.
const Function* imported_function(const Program& program, const NameExpr& name);
/// Returns the fields of the record that another file declares under a name; null if it declares none.
const std::vector<Parameter>* imported_fields(const Program& program, const NameExpr& name);
/// Collects the calls whose results a returned value is, or of which its elements are.
void collect_results(const Expr& returned, std::set<const Expr*>& results);

}  // namespace solitaire
