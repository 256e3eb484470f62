#pragma once

namespace solitaire {

/// A rectangle that is left out of a wall, through all its thickness. It is measured in shares of the wall:
/// across from its left end, as seen from its front, and up from its foot.
struct Opening {
  double left = 0, right = 1, low = 0, high = 1;
};

}  // namespace solitaire
