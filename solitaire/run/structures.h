#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "solitaire/run/operators.h"
#include "solitaire/value/elements.h"

namespace solitaire {

/// The layer of an evaluation that reads and changes lists and records.
class Structures : public Operators {
 public:
  /// a..b as a list.
  Value up_to(const Value& first, const Value& last, Span span);
  /// The element at an index, or the list of the elements at a list of indices.
  Value element(const Value& object, const Value& index, Span span);
  /// Whether one of the items equals the value, as a bool. Of ints that follow each other this is a
  /// comparison with the first and the last one.
  Value is_among(const Value& list, const Value& value, Span span);
  Value field(const Value& object, const FieldExpr& access);
  /// Gives the items of a list of that length to `give`, in order; an error of the program if it is none.
  template <class Give>
  void take_apart(const Value& value, std::size_t count, Span span, Give give) {
    const Value parts = checked_parts(value, count, span);
    for (std::size_t i = 0; i < count; ++i) give(i, parts.as_list()->items[i]);
  }
  Value make_record(const RecordStmt* type, std::vector<Value> fields, Span span);
  /// f of the items of a list; an error of the program if the value is none. `user` is what needs the list,
  /// for the message.
  template <class Function>
  Value with_items(const Value& value, const char* user, Span span, Function f) {
    return each_shape(value, [&](const Value& one) -> Value {
      if (one.as_list() == nullptr) needs_list(one, user, span);
      return f(one.as_list()->items);
    });
  }

  /// f of a list, of chosen length or not; an error of the program if the value is none. For what looks at
  /// each element by itself, under its guard.
  template <class Function>
  Value with_list(const Value& value, const char* user, Span span, Function f) {
    return each_alternative(value, [&](const Value& one) -> Value {
      if (!one.is_list()) needs_list(one, user, span);
      return f(one);
    });
  }
  /// Whether a list has the element of that number, as a bool. Of a packed list this is whether it has so
  /// many.
  Value has_element(const Elements& list, std::size_t number) {
    if (number >= list.size()) return false;
    const NodeId guard = list.guard(number);
    return guard == kTrue ? Value(true) : value_of(*graph_, guard);
  }
  /// Whether a list has any element, as a bool.
  Value has_any_element(const Elements& list) {
    Value any = false;
    for (std::size_t i = 0; i < list.size(); ++i) {
      any = either(any, has_element(list, i));
      if (any.is<bool>()) break;  // it has that one always
    }
    return any;
  }
  /// The guard of what is there where two elements with these guards are.
  NodeId guard_of_both(NodeId a, NodeId b) const { return path_.conjunction(a, b); }
  /// Counts a step for each part of a value, before all of it is looked at: lists that share their elements
  /// can have far more parts than there were steps to make them.
  void count_parts(const Value& value, Span span);

 protected:
  using Operators::Operators;

  /// Which of a record's fields an expression reads; an error of the program if it has none of that name.
  std::size_t field_position(const RecordStmt& type, const FieldExpr& access) {
    const std::uint32_t position = type.position(access.number);
    if (position == RecordStmt::kNoField) no_such_field(type, access);
    return position;
  }

  /// Changes a part of a value in place: its new value for its old one.
  using Change = std::function<void(Value&)>;
  void update_element(Value& object, const Value& index, Span span, const Change& change);
  void update_field(Value& object, const FieldExpr& target, const Change& change);
  /// Adds an element at the end of a list.
  void append(Value& list, const Value& element, Span span);
  /// Adds all elements of another list at the end of a list, in place if nothing shares the list.
  void append_all(Value& list, const Value& more, Span span);

 private:
  void count_largest(const Union& several, Span span);
  Value checked_parts(const Value& value, std::size_t count, Span span);
  [[noreturn]] void needs_list(const Value& value, const char* user, Span span);
  void check_indexed(const Value& object, const Value& index, Span span);
  [[noreturn]] void no_such_field(const RecordStmt& type, const FieldExpr& access);
  Value chosen_range(const Value& first, const Value& last, Span span);
  void append_one(Value& list, const GuardedElement& element, Span span);
  Value element_of(const Value& list, const Value& index, Span span);
  Value selected_scalar(const Elements& list, NodeId index, std::pair<std::int64_t, std::int64_t> possible);
  Value selected(const Elements& list, NodeId index, std::pair<std::int64_t, std::int64_t> possible);
  Value element_of_chosen(const Value& list, const Value& index, Span span);
  std::pair<std::int64_t, std::int64_t> require_index(const Elements& list, const Value& index, Span span);
  void update_chosen_list(Value& object, const Value& index, Span span, const Change& change);
  Value traced_element(const std::vector<Value>& items, const Value& index, Span span);
  std::size_t checked_index(const Value& index, std::size_t count, Span span);
  std::pair<std::int64_t, std::int64_t> possible_indices(const Value& index, std::size_t count, Span span);
  void update_where(Value& item, NodeId here, const Change& change);
};

}  // namespace solitaire
