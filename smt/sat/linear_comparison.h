#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "smt/sat/circuit.h"
#include "smt/sat/order_encoded_int.h"

namespace solitaire {

struct ScaledOrder {
  SharedOrder order;
  std::int64_t factor = 1;
};

/// Returns the literal of a bound: all terms times their factors come to `least` at least. It is written as a
/// linear bound where the solver takes those, as clauses where it counts or has few values, and else as
/// `in_gates` returns it, which is called then.
Literal linear_comparison(Circuit& circuit, std::vector<ScaledOrder> terms, std::int64_t least,
                          std::function<Literal()> in_gates);

}  // namespace solitaire
