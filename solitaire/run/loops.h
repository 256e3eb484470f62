#pragma once
#include <span>
#include <vector>

#include "solitaire/run/calls.h"
#include "solitaire/run/iteration.h"

namespace solitaire {

/// The layer of the walk that runs loops. Turns are run as long as there can be a further element, which only
/// some executions may have.
class Loops : public Calls {
 protected:
  using Calls::Calls;

  bool for_statement(const ForStmt& node);
  bool while_statement(const WhileStmt& node);
  Iteration iteration(const Expr& list);
  bool enter_turn(const Value& more, const Site& site, Span span, Exits& ends, std::span<const Slot> assigned,
                  const Value& value, std::size_t region);
  void set_variables(const std::vector<LoopVariable>& variables, const Value& value, Span span);

 private:
  template <class Enter>
  bool run_loop(const Stmt& body, std::span<const Slot> assigned, Enter enter);
  template <class Enter>
  bool run_path(const Stmt& body, Loop& loop, Enter enter);
  template <class Enter>
  bool run_paths(const Stmt& body, Loop& loop, Enter enter);
  bool turn(const Stmt& body, Loop& loop);
};

}  // namespace solitaire
