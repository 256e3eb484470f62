#pragma once
#include "engines/sample/shred/traced_structure.h"

namespace solitaire {

/// Lets the passages between two structures, from either to the other, draw the block, if nothing but floats
/// of the blocks comes or goes. Does nothing else.
void let_draw_block(TracedStructure& a, TracedStructure& b);

}  // namespace solitaire
