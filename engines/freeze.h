#pragma once
#include "engines/solution.h"
#include "solitaire/run/execution.h"
#include "tracegraph/address.h"

namespace solitaire {

/// Makes plain data of what an execution came to, whose texts have been added (add_texts()). Qualities, and
/// the choices on which things depend, are left to whoever knows them.
Solution solution_of(Execution execution, const AddressTable& addresses);

}  // namespace solitaire
