#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "base/random.h"
#include "engines/sample/move.h"
#include "engines/sample/shred/joint_move.h"
#include "engines/sample/shred/traced_structure.h"

namespace solitaire {

/// The joint moves of the structures of a chain: those with the same floats share one.
class JointMoves {
 public:
  JointMoves(RandomStream& stream, MoveTally& moves) : stream_(stream), moves_(moves) {}

  /// Is told of the structure that the present state takes, or of none.
  void enter(const TracedStructure* structure);
  /// Returns true if the floats of the present structure move together.
  bool ready() const { return present_ != nullptr && present_->ready(); }
  /// Moves them, if they do. A move that would leave the path is refused, as the one back would be.
  void move(Kernel& kernel);
  void end_warmup();

 private:
  RandomStream& stream_;
  MoveTally& moves_;
  std::map<std::vector<std::uint32_t>, JointMove> moves_of_;  // by the addresses of the floats
  JointMove* present_ = nullptr;
  bool warming_up_ = true;
};

}  // namespace solitaire
