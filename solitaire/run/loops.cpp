// Loops and comprehensions. What they run over is a list, a list whose length depends on choices, or a..b;
// turns are run as long as there can be a further element, each of which only some executions may have.
#include <fmt/format.h>

#include "solitaire/run/walk.h"

namespace solitaire {
namespace {

/// How many elements a..b may have as a value where its length depends on choices.
constexpr std::int64_t kLongestChosenRange = 4096;

}  // namespace

/// What a loop runs over.
class Walk::Iteration {
 public:
  /// Evaluates the list; a..b is not made into one.
  Iteration(Walk& walk, const Expr& list) : walk_(walk), span_(list.span) {
    if (list.kind == ExprKind::kBinary && static_cast<const BinaryExpr&>(list).op == BinaryOp::kUpTo) {
      const auto& range = static_cast<const BinaryExpr&>(list);
      first_ = walk.expression(*range.left);
      last_ = walk.expression(*range.right);
      is_range_ = first_.has_type(Type::kInt) && last_.has_type(Type::kInt);
      is_plain_ = first_.plain<std::int64_t>() != nullptr && last_.plain<std::int64_t>() != nullptr;
      if (!is_range_) value_ = walk.up_to(first_, last_, span_);
    } else {
      value_ = walk.expression(list);
    }
    if (!is_range_) keep_lists();
  }

  /// A bool: true where there is an element of that number.
  Value has(std::size_t number) {
    if (is_plain_)
      return static_cast<std::int64_t>(number) <= *last_.get<std::int64_t>() - *first_.get<std::int64_t>();
    if (is_range_) return within(number);
    if (several_ == nullptr) return number < list()->items.size();
    NodeId longer = kFalse;
    NodeId shorter = kFalse;
    for (const auto& [guard, value] : several_->alternatives) {
      NodeId& side = number < value.as_list()->items.size() ? longer : shorter;
      side = walk_.graph().disjunction(side, guard);
    }
    if (shorter == kFalse) return true;
    return value_of(walk_.graph(), longer);
  }

  Value element(std::size_t number) {
    if (is_plain_) return *first_.get<std::int64_t>() + static_cast<std::int64_t>(number);
    if (is_range_) return walk_.arithmetic(BinaryOp::kAdd, first_, static_cast<std::int64_t>(number), span_);
    if (several_ == nullptr) return list()->items[number];
    Value element;
    bool found = false;
    for (const auto& [guard, value] : several_->alternatives) {
      const auto& items = value.as_list()->items;
      if (number >= items.size()) continue;
      element = found ? merge(walk_.graph(), guard, items[number], element) : items[number];
      found = true;
    }
    return element;
  }

 private:
  const List* list() const { return value_.as_list(); }

  Value within(std::size_t number) {
    return walk_.compare(BinaryOp::kLessEqual, element(number), last_, span_);
  }

  /// Ends the paths on which the value is no list.
  void keep_lists() {
    value_ = walk_.each_shape(value_, [&](const Value& one) {
      if (one.as_list() == nullptr) {
        walk_.program_error(
            span_, fmt::format("{} cannot be looped over", describe(one)),
            one.has_type(Type::kInt) ? "loop over a range of ints: 0..n - 1" : "only lists can");
      }
      return one;
    });
    several_ = value_.as_union();
  }

  Walk& walk_;
  Span span_;
  bool is_range_ = false;
  bool is_plain_ = false;  // both ends are constants
  Value first_, last_, value_;
  const Union* several_ = nullptr;
};

Value Walk::up_to(const Value& first, const Value& last, Span span) {
  if (first.as_union() != nullptr || last.as_union() != nullptr) {
    return each_shape(first, [&](const Value& a) {
      return each_shape(last, [&](const Value& b) { return up_to(a, b, span); });
    });
  }
  if (!first.has_type(Type::kInt) || !last.has_type(Type::kInt)) {
    program_error(span,
                  fmt::format("'..' needs two ints, here are {} and {}", describe(first), describe(last)));
  }
  if (first.is<Symbol>() || last.is<Symbol>()) return chosen_range(first, last, span);
  const std::int64_t begin = *first.get<std::int64_t>();
  const std::int64_t end = *last.get<std::int64_t>();
  if (end >= begin) step(span, static_cast<std::uint64_t>(end - begin));
  if (first.traced() || last.traced()) {
    const Value length = int_operation(Op::kSub, last, first, span);
    follow(int_operation(Op::kEqInt, length, end - begin, span), span);
  }
  std::vector<Value> items;
  if (end >= begin) items.reserve(static_cast<std::size_t>(end - begin) + 1);
  for (std::int64_t i = begin; i <= end; ++i)
    items.push_back(int_operation(Op::kAdd, first, i - begin, span));
  return make_list(std::move(items), span);
}

/// a..b where its length depends on choices: a list of each length that it can have.
Value Walk::chosen_range(const Value& first, const Value& last, Span span) {
  const NodeId begin = node_of(*graph_, first);
  const NodeId length = apply(
      Op::kAdd, {apply(Op::kSub, {node_of(*graph_, last), begin}, span), graph_->constant(std::int64_t{1})},
      span);
  const Interval lengths = graph_->node(length).interval;
  const std::int64_t longest = std::max<std::int64_t>(lengths.hi, 0);
  const std::int64_t shortest = std::max<std::int64_t>(lengths.lo, 0);
  if (longest > kLongestChosenRange) {
    unsupported(span, fmt::format("this range can have up to {} elements, depending on choices", longest),
                fmt::format("at most {} can be kept as a list; a for over the range itself has no such limit",
                            kLongestChosenRange));
  }
  Value result;
  std::vector<Value> items;
  for (std::int64_t i = 0; i < longest; ++i) items.push_back(arithmetic(BinaryOp::kAdd, first, i, span));
  result = make_list(items, span);
  for (std::int64_t count = longest - 1; count >= shortest; --count) {
    items.pop_back();
    result = merge(*graph_, graph_->apply(Op::kLeInt, {length, graph_->constant(count)}),
                   make_list(items, span), result);
  }
  return result;
}

/// Goes into a further turn, if `more` can hold; where it can fail, the path that leaves is added to `ends`,
/// with the value.
bool Walk::enter_turn(const Value& given, const Site& site, Span span, Exits& ends,
                      std::span<const Slot> assigned, const Value& value, std::size_t region) {
  const Value more = settle(given);
  if (more.is<bool>()) {
    const bool goes_on = follow(more, span);
    note_taken(site, goes_on);
    if (!goes_on) add_exit(ends, path_.guard_since(region), assigned, value);
    return goes_on;
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
bool Walk::turn(const Stmt& body, Loop& loop) {
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

namespace {

/// Puts back, at the end of a scope, what a loop changes in it.
template <class T>
class Restored {
 public:
  Restored(T& variable, T value) : variable_(variable), before_(std::exchange(variable, std::move(value))) {}
  ~Restored() { variable_ = before_; }
  Restored(const Restored&) = delete;
  Restored& operator=(const Restored&) = delete;

 private:
  T& variable_;
  T before_;
};

}  // namespace

/// Runs turns until no path goes on, then joins all ways out of the loop. `enter` evaluates what decides
/// about a further turn and calls enter_turn.
template <class Enter>
bool Walk::run_loop(const Stmt& body, std::span<const Slot> assigned, Enter enter) {
  Loop loop;
  loop.assigned = assigned;
  const Checkpoint outside = checkpoint();
  const Restored<Loop*> restored_loop(loop_, &loop);
  const Restored<std::uint32_t> restored_levels(path_.levels, path_.levels);
  const auto losses = path_.losses;
  path_.enter_region();
  loop.region = path_.region();
  const Checkpoint start = checkpoint();
  turns_.push_back(0);
  try {
    while (enter(loop, turns_.back()) && turn(body, loop)) {
      ++turns_.back();
      step(body.span);
    }
  } catch (const PathEnd&) {
  }
  unwind(start);
  if (loop.breaks.any) resume(loop.breaks, assigned);
  unwind(outside);
  path_.losses.breaks = losses.breaks;
  if (!loop.breaks.any) return false;
  if (path_.losses != losses) path_.narrow(loop.breaks.guard);
  return true;
}

bool Walk::for_statement(const ForStmt& node) {
  Iteration items(*this, *node.list);
  return run_loop(*node.body, node.assigned, [&](Loop& loop, std::uint32_t number) {
    if (!enter_turn(items.has(number), node.site, node.list->span, loop.breaks, node.assigned, {},
                    loop.region))
      return false;
    set_variables(node.variables, items.element(number), node.list->span);
    return true;
  });
}

bool Walk::while_statement(const WhileStmt& node) {
  return run_loop(*node.body, node.assigned, [&](Loop& loop, std::uint32_t) {
    return enter_turn(tested(*node.condition), node.site, node.condition->span, loop.breaks, node.assigned,
                      {}, loop.region);
  });
}

void Walk::set_variables(const std::vector<LoopVariable>& variables, const Value& value, Span span) {
  if (variables.size() == 1) {
    slot(variables.front().slot) = value;
    return;
  }
  take_apart(value, variables.size(), span,
             [&](std::size_t i, Value part) { slot(variables[i].slot) = std::move(part); });
}

// ---- comprehensions: loops that collect

Value Walk::comprehension(const ComprehensionExpr& node) {
  Value collected = make_list({}, node.span);
  clause(node, 0, collected);
  return collected;
}

/// Runs the clause of that number over its list, adding to what the clauses around it collected.
void Walk::clause(const ComprehensionExpr& node, std::size_t number, Value& collected) {
  if (number == node.clauses.size()) {
    const Value element = expression(*node.element);
    return append(collected, element, node.span);
  }
  const ComprehensionClause& loop = node.clauses[number];
  Iteration items(*this, *loop.list);
  const Checkpoint outside = checkpoint();
  const Restored<std::uint32_t> restored_levels(path_.levels, path_.levels);
  const auto losses = path_.losses;
  path_.enter_region();
  const std::size_t region = path_.region();
  const Checkpoint start = checkpoint();
  Exits ends;
  turns_.push_back(0);
  try {
    while (enter_turn(items.has(turns_.back()), loop.site, loop.list->span, ends, node.assigned, collected,
                      region)) {
      step(node.span);
      set_variables(loop.variables, items.element(turns_.back()), loop.list->span);
      conditions(node, number, 0, collected);
      ++turns_.back();
    }
  } catch (const PathEnd&) {
  }
  unwind(start);
  if (ends.any) resume(ends, node.assigned);
  unwind(outside);
  path_.losses.breaks = losses.breaks;
  if (!ends.any) end_path();
  if (path_.losses != losses) path_.narrow(ends.guard);
  collected = std::move(ends.value);
}

/// Goes on to the next clause where the conditions from that number on hold.
void Walk::conditions(const ComprehensionExpr& node, std::size_t clause_number, std::size_t number,
                      Value& collected) {
  const ComprehensionClause& loop = node.clauses[clause_number];
  if (number == loop.conditions.size()) return clause(node, clause_number + 1, collected);
  const Expr& test = *loop.conditions[number];
  const Value holds = tested(test);
  if (holds.is<bool>()) {  // in place, without a copy of the list
    const bool goes_on = follow(holds, test.span);
    note_taken(loop.condition_sites[number], goes_on);
    if (goes_on) conditions(node, clause_number, number + 1, collected);
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
