#include "solitaire/run/loops.h"

namespace solitaire {

/// Evaluates what a loop runs over.
Iteration Loops::iteration(const Expr& list) {
  if (list.kind == ExprKind::kBinary && static_cast<const BinaryExpr&>(list).op == BinaryOp::kUpTo) {
    const auto& range = static_cast<const BinaryExpr&>(list);
    Value first = expression(*range.left);
    Value last = expression(*range.right);
    return {*this, std::move(first), std::move(last), list.span};
  }
  return {*this, expression(list), list.span};
}

/// Goes into a further turn, if `more` can hold; where it can fail, the path that leaves is added to `ends`,
/// with the value.
bool Loops::enter_turn(const Value& more, const Site& site, Span span, Exits& ends,
                       std::span<const Slot> assigned, const Value& value, std::size_t region) {
  if (const auto side = side_of(more, site, span)) {
    if (!*side) leave(ends, region, assigned, value);
    return *side;
  }
  Value unused;
  bool stays = false;
  NodeId inside = kFalse;
  std::uint32_t levels = 0;
  branch(
      more, site, span, {}, unused,
      [&](Value&) {
        stays = true;
        inside = path_.local();
        levels = path_.levels;
        return true;
      },
      [&](Value&) {
        add_exit(ends, path_.guard_since(region), assigned, value);
        return false;
      });
  if (!stays) return false;
  path_.set_local(inside);
  path_.facts.assume(node_of(*graph_, more), true);
  path_.levels = levels;  // later turns lie below this one
  return true;
}

/// Runs a loop's body once; false if no path comes to the next turn.
bool Loops::turn(const Stmt& body, Loop& loop) {
  const Checkpoint outside = checkpoint();
  const auto losses = path_.losses;
  loop.continues = {};
  path_.enter_region();
  loop.turn_region = path_.region();
  const Checkpoint start = checkpoint();
  bool goes_on = false;
  try {
    goes_on = statement(body);
  } catch (const PathEnd&) {
    unwind(start);
  }
  Exits& ends = loop.continues;
  if (goes_on && !ends.any) {  // the variables are as they should be
    ends.any = true;
    ends.guard = path_.local();
  } else {
    if (goes_on) add_exit(ends, path_.local(), loop.assigned, {});
    if (ends.any) resume(ends, loop.assigned);
  }
  unwind(outside);
  path_.losses.continues = losses.continues;
  if (!ends.any) return false;
  if (path_.losses != losses) path_.narrow(ends.guard);
  return true;
}

/// Runs turns until no path goes on, then joins all ways out of the loop. `enter` evaluates what decides
/// about a further turn and calls enter_turn.
template <class Enter>
bool Loops::run_loop(const Stmt& body, std::span<const Slot> assigned, Enter enter) {
  Loop loop;
  loop.assigned = assigned;
  Loop* const outer = std::exchange(loop_, &loop);
  const bool goes_on = forks_ ? run_paths(body, loop, enter) : run_path(body, loop, enter);
  loop_ = outer;
  return goes_on;
}

/// Runs it where there is but one path. If that ends, so does the execution.
template <class Enter>
bool Loops::run_path(const Stmt& body, Loop& loop, Enter enter) {
  turns_.push_back(0);
  while (enter(loop, turns_.back()) && (statement(body) || std::exchange(loop.continues.any, false))) {
    ++turns_.back();
    step(body.span);
  }
  turns_.pop_back();
  return loop.breaks.any;
}

template <class Enter>
bool Loops::run_paths(const Stmt& body, Loop& loop, Enter enter) {
  const Checkpoint outside = checkpoint();
  const std::uint32_t levels = path_.levels;
  const auto losses = path_.losses;
  path_.enter_region();
  loop.region = path_.region();
  const Checkpoint start = checkpoint();
  enter_loop();
  try {
    while (enter(loop, turns_.back()) && turn(body, loop)) {
      ++turns_.back();
      step(body.span);
    }
  } catch (const PathEnd&) {
  }
  unwind(start);
  if (loop.breaks.any) resume(loop.breaks, loop.assigned);
  unwind(outside);
  path_.levels = levels;
  path_.losses.breaks = losses.breaks;
  if (!loop.breaks.any) return false;
  if (path_.losses != losses) path_.narrow(loop.breaks.guard);
  return true;
}

bool Loops::for_statement(const ForStmt& node) {
  Iteration items = iteration(*node.list);
  return run_loop(*node.body, node.assigned, [&](Loop& loop, std::uint32_t number) {
    if (!enter_turn(items.has(number), node.site, node.list->span, loop.breaks, node.assigned, {},
                    loop.region))
      return false;
    set_variables(node.variables, items.element(number), node.list->span);
    return true;
  });
}

bool Loops::while_statement(const WhileStmt& node) {
  return run_loop(*node.body, node.assigned, [&](Loop& loop, std::uint32_t) {
    return enter_turn(tested(*node.condition), node.site, node.condition->span, loop.breaks, node.assigned,
                      {}, loop.region);
  });
}

void Loops::set_variables(const std::vector<LoopVariable>& variables, const Value& value, Span span) {
  if (forks_) loop_variables_.back() = &variables;
  if (variables.size() == 1) {
    slot(variables.front().slot) = value;
    return;
  }
  take_apart(value, variables.size(), span,
             [&](std::size_t i, Value part) { slot(variables[i].slot) = std::move(part); });
}

}  // namespace solitaire
