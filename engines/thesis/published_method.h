#pragma once
#include "engines/solve/executions/method.h"

namespace solitaire {

/// The way that the dissertation publishes, to measure against: 16 bits for every int (section 4.2.1), Z3's
/// default solver, unexplored sides asserted not to be taken (R in figure 4.3) and the all-different
/// constraint of section 4.2.3. It takes random exploration only (section 4.1.4), and gives choices no random
/// values.
const SearchMethod& published_method();

}  // namespace solitaire
