#pragma once
#include "solitaire/value/value.h"

namespace solitaire {

/// Returns what a variable holds where two paths join: `a` if the condition holds, else `b`.
///
/// Merging goes by shape. Values that are the same stay as they are; bools, ints and floats of one type
/// become a phi node; lists of equal length, records of one kind and strings of as many parts merge member by
/// member; of lists of different lengths, what they have in common at their ends stays, and the elements
/// between get guards; whatever differs in shape becomes a union of guarded alternatives, at most one for
/// each shape. (After Rosette; the dissertation's Phi of abstract frame values, section 4.3.2.) So n optional
/// list elements give one list of n elements with guards, and not one for each of n + 1 lengths or 2^n
/// subsets.
Value merge(Graph& graph, NodeId condition, const Value& a, const Value& b);

/// Returns true if merging the two makes no union and no list of chosen length. Assumes that neither is a
/// union.
bool same_shape(const Value& a, const Value& b);

/// The node of a bool, int or float, constant or not.
NodeId node_of(Graph& graph, const Value& value);
/// The value of a node: a constant if it is one, else a Symbol.
Value value_of(const Graph& graph, NodeId node);

}  // namespace solitaire
