#pragma once
#include "base/random.h"

namespace solitaire::tiles {

/// Returns a number from 0 to below 1.
inline double uniform(RandomStream& random) { return static_cast<double>(random.next() >> 11U) * 0x1p-53; }

}  // namespace solitaire::tiles
