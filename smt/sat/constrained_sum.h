#pragma once
#include "smt/sat/cnf.h"
#include "smt/sat/order_encoded_int.h"

namespace solitaire {

/// Returns the sum of two ints with literals that are inputs, which clauses tie to both: two of three
/// literals for each pair of values, and no gates. That takes fewer clauses than gates where the sum is read
/// both ways.
OrderEncodedInt constrained_sum(Circuit& circuit, Cnf& cnf, const OrderEncodedInt& a,
                                const OrderEncodedInt& b);

}  // namespace solitaire
