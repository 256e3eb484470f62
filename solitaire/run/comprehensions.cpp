#include "solitaire/run/comprehensions.h"

namespace solitaire {

Value Comprehensions::comprehension(const ComprehensionExpr& node) {
  Value collected = make_list({}, node.span);
  clause(node, 0, collected);
  return collected;
}

/// Runs the clause of that number over its list, adding to what the clauses around it collected.
void Comprehensions::clause(const ComprehensionExpr& node, std::size_t number, Value& collected) {
  if (number == node.clauses.size()) {
    const Value element = expression(*node.element);
    return append(collected, element, node.span);
  }
  Iteration items = iteration(*node.clauses[number].list);
  Exits ends;
  turns_.push_back(0);
  if (forks_) {
    run_paths(node, number, items, ends, collected);
  } else {
    run_turns(node, number, items, ends, collected);
  }
  turns_.pop_back();
  collected = std::move(ends.value);
}

/// Runs turns until no path goes on; `ends` is where they come to the end of the list.
void Comprehensions::run_turns(const ComprehensionExpr& node, std::size_t number, Iteration& items,
                               Exits& ends, Value& collected) {
  const ComprehensionClause& loop = node.clauses[number];
  const std::size_t region = path_.region();
  while (enter_turn(items.has(turns_.back()), loop.site, loop.list->span, ends, node.assigned, collected,
                    region)) {
    step(node.span);
    set_variables(loop.variables, items.element(turns_.back()), loop.list->span);
    conditions(node, number, 0, collected);
    ++turns_.back();
  }
}

void Comprehensions::run_paths(const ComprehensionExpr& node, std::size_t number, Iteration& items,
                               Exits& ends, Value& collected) {
  const Checkpoint outside = checkpoint();
  const std::uint32_t levels = path_.levels;
  const auto losses = path_.losses;
  path_.enter_region();
  const Checkpoint start = checkpoint();
  try {
    run_turns(node, number, items, ends, collected);
  } catch (const PathEnd&) {
  }
  unwind(start);
  if (ends.any) resume(ends, node.assigned);
  unwind(outside);
  path_.levels = levels;
  path_.losses.breaks = losses.breaks;
  if (!ends.any) end_path();
  if (path_.losses != losses) path_.narrow(ends.guard);
}

/// Goes on to the next clause where the conditions from that number on hold.
void Comprehensions::conditions(const ComprehensionExpr& node, std::size_t clause_number, std::size_t number,
                                Value& collected) {
  const ComprehensionClause& loop = node.clauses[clause_number];
  if (number == loop.conditions.size()) return clause(node, clause_number + 1, collected);
  const Expr& test = *loop.conditions[number];
  const Value holds = tested(test);
  if (const auto side = side_of(holds, loop.condition_sites[number], test.span)) {
    if (*side)
      conditions(node, clause_number, number + 1, collected);  // in place, without a copy of the list
    return;
  }
  collected = choose_side(
      holds, loop.condition_sites[number], test.span, node.assigned,
      [&] {
        Value more = collected;
        conditions(node, clause_number, number + 1, more);
        return more;
      },
      [&] { return collected; });
}

}  // namespace solitaire
