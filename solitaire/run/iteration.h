#pragma once
#include <cstdint>
#include <fmt/format.h>
#include <utility>

#include "solitaire/run/structures.h"
#include "solitaire/value/chosen_list.h"

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
    return evaluator_.has_element(Elements(list_), number);
  }

  Value element(std::size_t number) {
    if (is_plain_) return *first_.get<std::int64_t>() + static_cast<std::int64_t>(number);
    if (is_range_)
      return evaluator_.arithmetic(BinaryOp::kAdd, first_, static_cast<std::int64_t>(number), span_);
    return Elements(list_).value(number);
  }

 private:
  Value within(std::size_t number) {
    return evaluator_.compare(BinaryOp::kLessEqual, element(number), last_, span_);
  }

  /// Ends the paths on which the value is no list.
  void keep_lists(const Value& value) {
    list_ = evaluator_.each_alternative(value, [&](const Value& one) {
      if (!one.is_list()) {
        evaluator_.program_error(
            span_, fmt::format("{} cannot be looped over", describe(one)),
            one.has_type(Type::kInt) ? "loop over a range of ints: 0..n - 1" : "only lists can");
      }
      return one;
    });
    if (list_.is<ChosenList>()) list_ = packed(evaluator_.graph(), list_);
  }

  Structures& evaluator_;
  Span span_;
  bool is_range_ = false;
  bool is_plain_ = false;  // both ends are constants
  Value first_, last_;
  Value list_;  // packed, so that the turn of an element is its place
};

}  // namespace solitaire
