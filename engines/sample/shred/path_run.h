#pragma once
#include <optional>

#include "engines/sample/fresh_values.h"
#include "engines/sample/proposal.h"
#include "engines/sample/shred/traced_structure.h"

namespace solitaire {

/// Runs executions on paths that are traced already: what Rerun does by running the program. Which path an
/// execution takes shows when it is run, so all functions return nothing where it takes another one.
class PathRun {
 public:
  PathRun(RandomStream& stream, FreshValues& fresh) : stream_(stream), fresh_(fresh) {}

  /// Proposes the execution behind the passage in which a choice has another value, as Rerun::propose() does,
  /// and returns the same; or draws the block there, too. The structure behind it has its values then.
  std::optional<double> propose(TracedStructure& from, ChoiceNumber picked, const Proposal& proposal,
                                const Passage& passage);
  /// Draws all choices of an execution anew. Returns the logarithm of its weight, which is minus infinity
  /// where it is impossible.
  std::optional<double> restart(Kernel& to);

 private:
  template <class Known>
  Kernel::Outcome follow(Kernel& to, Known known);
  double draw_block(TracedStructure& from, TracedStructure& to);

  RandomStream& stream_;
  FreshValues& fresh_;
  double drawn_density_ = 0;  // of what the last run drew
};

}  // namespace solitaire
