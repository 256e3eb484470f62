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
  const ComprehensionClause& loop = node.clauses[number];
  collect({iteration(*loop.list), loop.site, loop.list->span, node.assigned}, collected,
          [&](const Value& element) {
            step(node.span);
            set_variables(loop.variables, element, loop.list->span);
            conditions(node, number, 0, collected);
          });
}

/// Runs `turn` for each element, one after the other; it adds to what was collected before.
template <class Turn>
void Comprehensions::collect(Source source, Value& collected, Turn turn) {
  Exits ends;
  enter_loop();
  if (forks_) {
    run_paths(source, ends, collected, turn);
  } else {
    run_turns(source, ends, collected, turn);
  }
  turns_.pop_back();
  collected = std::move(ends.value);
}

/// Runs turns until no path goes on; `ends` is where they come to the end of the list.
template <class Turn>
void Comprehensions::run_turns(Source& source, Exits& ends, Value& collected, Turn turn) {
  const std::size_t region = path_.region();
  while (enter_turn(source.items.has(turns_.back()), source.site, source.span, ends, source.assigned,
                    collected, region)) {
    turn(source.items.element(turns_.back()));
    ++turns_.back();
  }
}

template <class Turn>
void Comprehensions::run_paths(Source& source, Exits& ends, Value& collected, Turn turn) {
  const Checkpoint outside = checkpoint();
  const std::uint32_t levels = path_.levels;
  const auto losses = path_.losses;
  path_.enter_region();
  const Checkpoint start = checkpoint();
  try {
    run_turns(source, ends, collected, turn);
  } catch (const PathEnd&) {
  }
  unwind(start);
  if (ends.any) resume(ends, source.assigned);
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
  const auto nothing = [&] { return make_list({}, node.span); };
  const Value more = choose_side(
      holds, loop.condition_sites[number], test.span, node.assigned,
      [&] {
        Value made = nothing();
        conditions(node, clause_number, number + 1, made);
        return made;
      },
      nothing);
  append_all(collected, more, node.span);
}

// ---- the same with functions

Value Comprehensions::map_list(const Value& function, const Value& list, const CallExpr& site) {
  Value collected = make_list({}, site.span);
  collect(
      {Iteration(*this, list, site.span), site.site, site.span, {}}, collected,
      [&](const Value& element) { append(collected, call_function(function, site, {element}), site.span); });
  return collected;
}

Value Comprehensions::filter_list(const Value& function, const Value& list, const CallExpr& site) {
  Value collected = make_list({}, site.span);
  collect({Iteration(*this, list, site.span), site.site, site.span, {}}, collected,
          [&](const Value& element) {
            const Value holds = condition(call_function(function, site, {element}), site.span);
            const Value more = choose_side(
                holds, Site{}, site.span, {}, [&] { return make_list({element}, site.span); },
                [&] { return make_list({}, site.span); });
            append_all(collected, more, site.span);
          });
  return collected;
}

}  // namespace solitaire
