#pragma once
#include <vector>

#include "solitaire/run/scalar_operations.h"
#include "solitaire/value/chosen_list.h"

namespace solitaire {

/// The layer of an evaluation that compares values: numbers by size, and values of all kinds by what they
/// are made of.
class Comparisons : public ScalarOperations {
 public:
  /// One of <, <=, > and >= of two numbers.
  Value compare(BinaryOp op, const Value& a, const Value& b, Span span);
  /// Structural equality, as a bool. It takes a step for each pair of members, which count at `span`.
  Value equal(const Value& a, const Value& b, Span span = {});
  /// The same list, packed: an element's index is then its place.
  Value in_place(const Value& list) { return list.is<ChosenList>() ? packed(*graph_, list) : list; }
  /// A text that only the execution of a solution knows; `span` is what makes it.
  Value opaque_string(Span span);
  /// For what needs to know what a string says.
  void check_known(const Value& text);

 protected:
  using ScalarOperations::ScalarOperations;

 private:
  Value equal_texts(const Value& a, const Value& b);
  Value equal_shaped(const Value& a, const Value& b, Span span);
  Value equal_members(const std::vector<Value>& a, const std::vector<Value>& b, Span span);
  Value equal_lists(const Value& a, const Value& b, Span span);
  /// An int, constant or not, against a constant float: exactly, without making a float of the int.
  Value int_equals(const Value& a, double b);
  Value int_below(const Value& a, double b, bool strict, Span span);
  Value int_above(const Value& a, double b, bool strict, Span span);
};

}  // namespace solitaire
