#pragma once
#include <cstdint>
#include <fmt/format.h>
#include <utility>

#include "solitaire/run/structures.h"

namespace solitaire {

/// What a loop runs over: a list, a list whose length depends on choices, or a..b.
class Iteration {
 public:
  /// Over a..b, which is not made into a list.
  Iteration(Structures& evaluator, Value first, Value last, Span span)
      : evaluator_(evaluator), span_(span), first_(std::move(first)), last_(std::move(last)) {
    is_range_ = first_.has_type(Type::kInt) && last_.has_type(Type::kInt);
    is_plain_ = first_.plain<std::int64_t>() != nullptr && last_.plain<std::int64_t>() != nullptr;
    if (!is_range_) keep_lists(evaluator.up_to(first_, last_, span));
  }
  Iteration(Structures& evaluator, const Value& list, Span span) : evaluator_(evaluator), span_(span) {
    keep_lists(list);
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
      side = evaluator_.graph().disjunction(side, guard);
    }
    if (shorter == kFalse) return true;
    return value_of(evaluator_.graph(), longer);
  }

  Value element(std::size_t number) {
    if (is_plain_) return *first_.get<std::int64_t>() + static_cast<std::int64_t>(number);
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

  Value within(std::size_t number) {
    return evaluator_.compare(BinaryOp::kLessEqual, element(number), last_, span_);
  }

  /// Ends the paths on which the value is no list.
  void keep_lists(const Value& value) {
    value_ = evaluator_.each_shape(value, [&](const Value& one) {
      if (one.as_list() == nullptr) {
        evaluator_.program_error(
            span_, fmt::format("{} cannot be looped over", describe(one)),
            one.has_type(Type::kInt) ? "loop over a range of ints: 0..n - 1" : "only lists can");
      }
      return one;
    });
    several_ = value_.as_union();
  }

  Structures& evaluator_;
  Span span_;
  bool is_range_ = false;
  bool is_plain_ = false;  // both ends are constants
  Value first_, last_, value_;
  const Union* several_ = nullptr;
};

}  // namespace solitaire
