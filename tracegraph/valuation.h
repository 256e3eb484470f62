#pragma once
#include <map>

#include "tracegraph/address.h"
#include "tracegraph/scalar.h"

namespace solitaire {

/// Which value each choice of an execution has: the one map from addresses to values. The addresses belong to
/// one AddressTable; text of them is made where results leave the program, and nowhere else.
///
/// The map is ordered by address number, which is the order in which addresses were first met.
using Valuation = std::map<AddressId, TypedScalar>;

}  // namespace solitaire
