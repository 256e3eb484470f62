#include "solitaire/builtins/box_functions.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "solitaire/run/evaluation.h"

namespace solitaire {
namespace {

using Call = const BuiltinCall&;

/// The least or greatest that a number can be, exactly: a long double holds every int and every float.
using Bound = long double;

struct Bounds {
  Bound least;
  Bound greatest;
};

Bounds bounds_of(Evaluator& evaluator, const Value& number) {
  if (const std::int64_t* known = number.plain<std::int64_t>())
    return {static_cast<Bound>(*known), static_cast<Bound>(*known)};
  if (const double* known = number.plain<double>()) return {*known, *known};
  if (!number.has_type(Type::kInt))
    return {-std::numeric_limits<Bound>::infinity(), std::numeric_limits<Bound>::infinity()};
  const Interval values = evaluator.graph().node(node_of(evaluator.graph(), number)).interval;
  return {static_cast<Bound>(values.lo), static_cast<Bound>(values.hi)};
}

/// What a box takes along an axis.
struct Side {
  Value low;
  Value reach;  // its end and the gap behind it
  Bound least_low;
  Bound greatest_reach;
};

struct Box {
  Value there;  // whether the list has it
  std::vector<Side> sides;
};

[[noreturn]] void no_box(Evaluator& evaluator, Call call) {
  evaluator.program_error(
      call.site.span, "'boxes_apart' needs boxes of as many axes, each a list of [low, high] for each axis");
}

Value checked_number(Evaluator& evaluator, Call call, const Value& value) {
  return evaluator.each_shape(value, [&](const Value& one) {
    if (!one.is_number())
      evaluator.program_error(call.site.span,
                              "'boxes_apart' needs numbers for ends and gap, here is " + describe(one));
    return one;
  });
}

Side side_of(Evaluator& evaluator, Call call, const Value& ends, const Value& gap) {
  const List* both = ends.as_list();
  if (both == nullptr || both->items.size() != 2) no_box(evaluator, call);
  const Value low = checked_number(evaluator, call, both->items[0]);
  const Value high = checked_number(evaluator, call, both->items[1]);
  const Value reach = evaluator.arithmetic(BinaryOp::kAdd, high, gap, call.site.span);
  return {low, reach, bounds_of(evaluator, low).least, bounds_of(evaluator, reach).greatest};
}

/// Reads the boxes, each where the list has it. One that is never there, or of which reading ends the path,
/// has no sides.
std::vector<Box> read_boxes(Evaluator& evaluator, Call call, const Value& list, const Value& gap) {
  const Elements items(list);
  std::vector<Box> boxes(items.size());
  const auto read = [&](const Value& value) {
    std::vector<Side> sides;
    const List* axes = value.as_list();
    if (axes == nullptr || axes->items.empty()) no_box(evaluator, call);
    for (const Value& ends : axes->items) sides.push_back(side_of(evaluator, call, ends, gap));
    return sides;
  };
  std::size_t axes = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    boxes[i].there = evaluator.has_element(items, i);
    const auto read_here = [&] {
      std::vector<Side> sides = read(items.value(i));
      if (axes == 0) axes = sides.size();
      if (sides.size() != axes) no_box(evaluator, call);
      boxes[i].sides = std::move(sides);
      return Value::nil();
    };
    evaluator.where(boxes[i].there, call.site.span, read_here, Value::nil());
  }
  return boxes;
}

/// Returns true if a ends before b begins, whatever is chosen.
bool is_before(const Side& a, const Side& b) { return a.greatest_reach <= b.least_low; }

bool can_overlap(const Box& a, const Box& b) {
  for (std::size_t axis = 0; axis < a.sides.size(); ++axis) {
    if (is_before(a.sides[axis], b.sides[axis]) || is_before(b.sides[axis], a.sides[axis])) return false;
  }
  return true;
}

/// Numbers of two boxes: the later one first, so that pairs come in the order in which boxes are added one by
/// one.
struct Pair {
  std::uint32_t later;
  std::uint32_t earlier;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// Returns the pairs that can overlap, in order. A box is taken out of the sweep once it ends before all
/// boxes that are still to come.
std::vector<Pair> pairs_that_can_overlap(Evaluator& evaluator, const std::vector<Box>& boxes, Span span) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].sides.empty()) order.push_back(i);
  }
  const auto along = [&](std::uint32_t box) -> const Side& { return boxes[box].sides[0]; };
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return along(i).least_low; });
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> open;
  for (const std::uint32_t next : order) {
    std::erase_if(open, [&](std::uint32_t one) { return is_before(along(one), along(next)); });
    const std::size_t before = pairs.size();
    for (const std::uint32_t one : open) {
      if (can_overlap(boxes[one], boxes[next])) pairs.push_back({std::max(one, next), std::min(one, next)});
    }
    evaluator.step(span, 1 + pairs.size() - before);
    open.push_back(next);
  }
  std::ranges::sort(pairs);
  return pairs;
}

Value are_apart(Evaluator& evaluator, const Box& a, const Box& b, Span span) {
  const auto along_some_axis = [&] {
    Value apart = false;
    for (std::size_t axis = 0; axis < a.sides.size(); ++axis) {
      for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        const Value before =
            evaluator.compare(BinaryOp::kLessEqual, first->sides[axis].reach, second->sides[axis].low, span);
        apart = evaluator.binary(Op::kOr, apart, before, span);  // one node, of which there are many
      }
    }
    return apart;
  };
  return evaluator.where(evaluator.both(a.there, b.there), span, along_some_axis, true);
}

bool is_known_false(const Value& condition) {
  const bool* known = condition.plain<bool>();
  return known != nullptr && !*known;
}

Value all_apart(Evaluator& evaluator, const std::vector<Box>& boxes, Span span) {
  Value apart = true;
  for (const auto& [later, earlier] : pairs_that_can_overlap(evaluator, boxes, span)) {
    apart = evaluator.both(apart, are_apart(evaluator, boxes[later], boxes[earlier], span));
    if (is_known_false(apart)) break;
  }
  return apart;
}

}  // namespace

Value boxes_apart(Evaluator& evaluator, Call call) {
  const Value gap =
      given(call.arguments[1]) ? checked_number(evaluator, call, call.arguments[1]) : std::int64_t{0};
  return evaluator.with_list(call.arguments[0], "boxes_apart", call.site.span, [&](const Value& list) {
    return all_apart(evaluator, read_boxes(evaluator, call, list, gap), call.site.span);
  });
}

}  // namespace solitaire
