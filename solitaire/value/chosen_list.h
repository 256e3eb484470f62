#pragma once
#include "solitaire/value/value.h"

namespace solitaire {

/// Returns one list behind the other.
Value concatenate_lists(const Value& a, const Value& b);

/// Returns the same list, packed. Of a list of n elements that is not, this makes about n * n / 2 times three
/// nodes, since each element can come to lie in each place up to its own.
Value packed(Graph& graph, const Value& list);

/// Returns how many elements a list has, as an int.
NodeId length_of(Graph& graph, const Value& list);

/// Returns a list of chosen length as a union of lists, one for each length.
Value of_each_length(Graph& graph, const Value& list);

}  // namespace solitaire
