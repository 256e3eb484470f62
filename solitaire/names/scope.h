#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/name_table.h"
#include "solitaire/names/site_labels.h"
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// The variables that the statements at hand may assign, for each branch and loop around them.
class AssignedSlots {
 public:
  void add(Slot slot);

  /// Runs `body`, and adds to `assigned` the variables that it assigns.
  template <class Body>
  void collect(std::vector<Slot>& assigned, Body body) {
    collectors_.push_back(&assigned);
    body();
    collectors_.pop_back();
  }

 private:
  std::vector<std::vector<Slot>*> collectors_;
};

/// A function that the resolver is in, with all that it knows of it.
struct Scope {
  Scope(Function& which, Scope* around, NameTable& labels) : function(which), outer(around), sites(labels) {}

  Function& function;
  Scope* outer;  // null at the top level of a module
  std::map<std::string, Slot> names;
  std::vector<Span> definitions;                    // by slot: where the variable is first assigned
  std::vector<std::pair<std::string, Slot>> inner;  // comprehension variables in force, innermost last
  std::set<Slot> read_inside;                       // variables that inner functions read
  std::map<std::string, const RecordStmt*> records;
  SiteLabels sites;
  std::vector<std::pair<Site*, std::string>> parameter_calls;  // of a library function: of what it was given
  std::set<const Expr*> results;  // what the function returns as it is, or as elements of a list
  AssignedSlots assigned;
  std::string purpose;  // what the expression at hand is assigned to or passed as
  int loops = 0;        // how many loops are around the statement at hand
  int blocks = 0;       // how many blocks are

  /// Returns the slot of a variable of the function, which is made if there is none yet.
  Slot declare(const std::string& name, Span place);
  /// Makes a variable that only a comprehension sees, until `inner` is cut back.
  Slot declare_inner(const std::string& name, Span place);
  std::optional<Slot> find(const std::string& name) const;

 private:
  Slot add_slot(const std::string& name, Span place);
};

/// Declares what a function assigns anywhere in its body: every such name is its own throughout.
void declare_assigned(const Stmt& body, Scope& scope);

}  // namespace solitaire
