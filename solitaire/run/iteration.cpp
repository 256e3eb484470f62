// Loops and comprehensions. What they run over is a list, a list whose length depends on choices, or a..b;
// turns are run as long as there can be a further element, each of which only some executions may have.
#include <fmt/format.h>

#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

/// How many elements a..b may have as a value where its length depends on choices.
constexpr std::int64_t kLongestChosenRange = 4096;

}  // namespace

/// What a loop runs over.
class Evaluator::Iteration {
 public:
  /// Evaluates the list; a..b is not made into one.
  Iteration(Evaluator& evaluator, const Expr& list) : evaluator_(evaluator), span_(list.span) {
    if (list.kind == ExprKind::kBinary && static_cast<const BinaryExpr&>(list).op == BinaryOp::kUpTo) {
      const auto& range = static_cast<const BinaryExpr&>(list);
      first_ = evaluator.expression(*range.left);
      last_ = evaluator.expression(*range.right);
      is_range_ = first_.has_type(Type::kInt) && last_.has_type(Type::kInt);
      if (!is_range_) value_ = evaluator.up_to(first_, last_, span_);
    } else {
      value_ = evaluator.expression(list);
    }
    if (!is_range_) keep_lists();
  }

  /// Whether there is an element of that number.
  NodeId has(std::size_t number) {
    if (is_range_) return within(number);
    if (several_ == nullptr) return number < list()->items.size() ? kTrue : kFalse;
    NodeId longer = kFalse;
    NodeId shorter = kFalse;
    for (const auto& [guard, value] : several_->alternatives) {
      NodeId& side = number < value.as_list()->items.size() ? longer : shorter;
      side = evaluator_.graph().disjunction(side, guard);
    }
    if (shorter == kFalse) return kTrue;
    return longer;
  }

  Value element(std::size_t number) {
    if (is_range_)
      return evaluator_.arithmetic(BinaryOp::kAdd, first_, static_cast<std::int64_t>(number), span_);
    if (several_ == nullptr) return list()->items[number];
    Value element;
    bool found = false;
    for (const auto& [guard, value] : several_->alternatives) {
      const auto& items = value.as_list()->items;
      if (number >= items.size()) continue;
      element = found ? merge(evaluator_.graph(), guard, items[number], element) : items[number];
      found = true;
    }
    return element;
  }

 private:
  const List* list() const { return value_.as_list(); }

  NodeId within(std::size_t number) {
    const Value element =
        evaluator_.arithmetic(BinaryOp::kAdd, first_, static_cast<std::int64_t>(number), span_);
    return evaluator_.condition(evaluator_.compare(BinaryOp::kLessEqual, element, last_, span_), span_);
  }

  /// Ends the paths on which the value is no list.
  void keep_lists() {
    value_ = evaluator_.each_shape(value_, [&](const Value& one) {
      if (one.as_list() == nullptr) {
        evaluator_.program_error(
            span_, fmt::format("{} cannot be looped over", describe(one)),
            one.has_type(Type::kInt) ? "loop over a range of ints: 0..n - 1" : "only lists can");
      }
      return one;
    });
    several_ = value_.as_union();
  }

  Evaluator& evaluator_;
  Span span_;
  bool is_range_ = false;
  Value first_, last_, value_;
  const Union* several_ = nullptr;
};

Value Evaluator::up_to(const Value& first, const Value& last, Span span) {
  if (first.as_union() != nullptr || last.as_union() != nullptr) {
    return each_shape(first, [&](const Value& a) {
      return each_shape(last, [&](const Value& b) { return up_to(a, b, span); });
    });
  }
  if (!first.has_type(Type::kInt) || !last.has_type(Type::kInt)) {
    program_error(span,
                  fmt::format("'..' needs two ints, here are {} and {}", describe(first), describe(last)));
  }
  if (first.is<std::int64_t>() && last.is<std::int64_t>()) {
    std::vector<Value> items;
    const std::int64_t end = *last.get<std::int64_t>();
    if (end >= *first.get<std::int64_t>())
      step(span, static_cast<std::uint64_t>(end - *first.get<std::int64_t>()));
    for (std::int64_t i = *first.get<std::int64_t>(); i <= end; ++i) items.emplace_back(i);
    return make_list(std::move(items), span);
  }
  const NodeId begin = node_of(graph_, first);
  const NodeId length =
      apply(Op::kAdd,
            {apply(Op::kSub, {node_of(graph_, last), begin}, span), graph_.constant(std::int64_t{1})}, span);
  const Interval lengths = graph_.node(length).interval;
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
    result = merge(graph_, graph_.apply(Op::kLeInt, {length, graph_.constant(count)}), make_list(items, span),
                   result);
  }
  return result;
}

/// Goes into a further turn, if `more` can hold; where it can fail, the path that leaves is added to `ends`.
bool Evaluator::enter_turn(NodeId more, const Site& site, Span span, Exits& ends,
                           std::span<const Slot> assigned, Value value, std::size_t region) {
  more = settle(more);
  if (more == kTrue || more == kFalse) {
    note_taken(site, more == kTrue);
    if (more == kFalse) add_exit(ends, path_.guard_since(region), assigned, std::move(value));
    return more == kTrue;
  }
  check_condition(more, span);
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
        add_exit(ends, path_.guard_since(region), assigned, std::move(value));
        return false;
      });
  if (!stays) return false;
  path_.set_local(inside);
  path_.facts.assume(more, true);
  path_.levels = levels;  // later turns lie below this one
  return true;
}

/// Runs a loop's body once; false if no path comes to the next turn.
bool Evaluator::turn(const Stmt& body, Loop& loop) {
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
  if (goes_on) add_exit(ends, path_.local(), loop.assigned, {});
  if (ends.any) resume(ends, loop.assigned);
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
bool Evaluator::run_loop(const Stmt& body, std::span<const Slot> assigned, Enter enter) {
  Loop loop;
  loop.assigned = assigned;
  const Checkpoint outside = checkpoint();
  const Restored<Loop*> restored_loop(loop_, &loop);
  const Restored<std::uint32_t> restored_levels(path_.levels, path_.levels);
  const auto losses = path_.losses;
  path_.enter_region();
  loop.region = path_.region();
  const Checkpoint start = checkpoint();
  current_->turns.push_back(0);
  const std::size_t turns = current_->turns.size();
  try {
    while (enter(loop, current_->turns.back()) && turn(body, loop)) {
      ++current_->turns.back();
      step(body.span);
    }
  } catch (const PathEnd&) {
    unwind(start);
    current_->turns.resize(turns);
  }
  current_->turns.pop_back();
  if (loop.breaks.any) resume(loop.breaks, assigned);
  unwind(outside);
  path_.losses.breaks = losses.breaks;
  if (!loop.breaks.any) return false;
  if (path_.losses != losses) path_.narrow(loop.breaks.guard);
  return true;
}

bool Evaluator::for_statement(const ForStmt& node) {
  Iteration items(*this, *node.list);
  return run_loop(*node.body, node.assigned, [&](Loop& loop, std::uint32_t number) {
    if (!enter_turn(items.has(number), node.site, node.list->span, loop.breaks, node.assigned, {},
                    loop.region))
      return false;
    set_variables(node.variables, items.element(number), node.list->span);
    return true;
  });
}

bool Evaluator::while_statement(const WhileStmt& node) {
  return run_loop(*node.body, node.assigned, [&](Loop& loop, std::uint32_t) {
    const NodeId more = condition(expression(*node.condition), node.condition->span);
    return enter_turn(more, node.site, node.condition->span, loop.breaks, node.assigned, {}, loop.region);
  });
}

void Evaluator::set_variables(const std::vector<LoopVariable>& variables, const Value& value, Span span) {
  if (variables.size() == 1) {
    current_->frame->slots[variables.front().slot] = value;
    return;
  }
  take_apart(value, variables.size(), span,
             [&](std::size_t i, Value part) { current_->frame->slots[variables[i].slot] = std::move(part); });
}

// ---- comprehensions: loops that collect

Value Evaluator::comprehension(const ComprehensionExpr& node) {
  Value collected = make_list({}, node.span);
  clause(node, 0, collected);
  return collected;
}

void Evaluator::append(Value& collected, const Value& element, Span span) {
  if (collected.is<List>() && collected.unique()) {
    List& list = collected.own<List>();
    list.items.push_back(element);
    list.nesting = std::max(list.nesting, 1 + nesting(element));
    return check_nesting(collected, span);
  }
  collected = each_shape(collected, [&](const Value& list) {
    std::vector<Value> items = list.as_list()->items;
    items.push_back(element);
    return make_list(std::move(items), span);
  });
}

/// Runs the clause of that number over its list, adding to what the clauses around it collected.
void Evaluator::clause(const ComprehensionExpr& node, std::size_t number, Value& collected) {
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
  current_->turns.push_back(0);
  const std::size_t turns = current_->turns.size();
  try {
    while (enter_turn(items.has(current_->turns.back()), loop.site, loop.list->span, ends, node.assigned,
                      collected, region)) {
      step(node.span);
      set_variables(loop.variables, items.element(current_->turns.back()), loop.list->span);
      conditions(node, number, 0, collected);
      ++current_->turns.back();
    }
  } catch (const PathEnd&) {
    unwind(start);
    current_->turns.resize(turns);
  }
  current_->turns.pop_back();
  if (ends.any) resume(ends, node.assigned);
  unwind(outside);
  path_.losses.breaks = losses.breaks;
  if (!ends.any) end_path();
  if (path_.losses != losses) path_.narrow(ends.guard);
  collected = std::move(ends.value);
}

/// Goes on to the next clause where the conditions from that number on hold.
void Evaluator::conditions(const ComprehensionExpr& node, std::size_t clause_number, std::size_t number,
                           Value& collected) {
  const ComprehensionClause& loop = node.clauses[clause_number];
  if (number == loop.conditions.size()) return clause(node, clause_number + 1, collected);
  const Expr& test = *loop.conditions[number];
  const NodeId holds = condition(expression(test), test.span);
  if (holds == kTrue || holds == kFalse) {  // in place, without a copy of the list
    note_taken(loop.condition_sites[number], holds == kTrue);
    if (holds == kTrue) conditions(node, clause_number, number + 1, collected);
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
