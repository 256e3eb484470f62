#pragma once
#include "base/random.h"
#include "engines/sample/move.h"
#include "engines/sample/proposal.h"
#include "engines/sample/shred/slice_sampler.h"
#include "engines/sample/shred/traced_structure.h"

namespace solitaire {

/// Changes of single choices on which no branch depends, so that executions stay on their path.
class PathMoves {
 public:
  PathMoves(RandomStream& stream, Proposer& proposer, MoveTally& moves)
      : stream_(stream), proposer_(proposer), moves_(moves), slice_sampler_(stream) {}

  /// Gives each of these choices its turn, one after the other, which is worth about twice as much as if they
  /// were picked (Roberts and Sahu 1997). The order may not depend on the state: these choices are the same
  /// in all states that they lead to. `floats_move` is true if floats also move together. What can be tuned
  /// is tuned if `learns` is true.
  void scan(TracedStructure& structure, bool floats_move, bool learns);

 private:
  bool draw_block(TracedStructure& structure);
  bool change_by_form(Kernel& kernel, ChoiceNumber choice);
  void set(Kernel& kernel, ChoiceNumber choice, Scalar value);
  void change_anywhere(Kernel& kernel, ChoiceNumber choice);
  void change(Kernel& kernel, ChoiceNumber choice, Scalar value, Move move);

  RandomStream& stream_;
  Proposer& proposer_;
  MoveTally& moves_;
  SliceSampler slice_sampler_;
};

}  // namespace solitaire
