#pragma once
#include "base/random.h"
#include "engines/sample/shred/float_space.h"
#include "engines/sample/shred/spread.h"
#include "engines/sample/shred/step_size.h"
#include "kernel/kernel.h"

namespace solitaire {

/// Moves the floats of a path together, along the slopes of the density (trajectory.h), once the warm-up has
/// shown how they lie. Where floats hang together, as a slope and an intercept far from the data, single ones
/// can hardly move.
class JointMove {
 public:
  /// With `always` also where the floats do not hang together.
  JointMove(std::size_t size, bool always);

  bool ready() const { return spread_.known() && (always_ || spread_.hangs_together()); }
  struct Result {
    bool moved;
    bool diverged;  // see Trouble::kDivergence
  };
  /// The move is tuned if it `learns`.
  Result move(Kernel& kernel, RandomStream& stream, bool learns);
  /// Is told of the kernel's present state during the warm-up, once in a sweep, before and after the move.
  void watch_single_moves(Kernel& kernel) { spread_.watch_single_moves(FloatSpace(kernel).present()); }
  void watch(Kernel& kernel);
  void end_warmup() { step_size_.settle(); }

 private:
  Spread spread_;
  bool always_;
  StepSize step_size_;
};

}  // namespace solitaire
