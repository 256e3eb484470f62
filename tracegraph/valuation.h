#pragma once
#include <map>

#include "tracegraph/address.h"
#include "tracegraph/scalar.h"

namespace solitaire {

/// The values of the choices of an execution, by address. All addresses belong to one AddressTable. Their
/// text is made where results leave the program, and nowhere else.
///
/// The map is ordered by address number, which is the order in which addresses were first met.
using Valuation = std::map<AddressId, TypedScalar>;

}  // namespace solitaire
