#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "kernel/kernel.h"

namespace solitaire {

struct TracedStructure;

/// How executions on one path become executions on another when one of their choices changes.
struct Passage {
  static constexpr ChoiceNumber kNew = SIZE_MAX;

  TracedStructure* to;
  std::vector<ChoiceNumber> origins;    // of the choices there: their numbers here, or kNew
  std::vector<ChoiceNumber> forgotten;  // the choices here that are not there
  /// Whether the floats of the block there are drawn anew on the way, all of them, as those here are on the
  /// way back. Then it matters for neither way what they were.
  bool draws_block = false;
};

/// The passages from one structure. Where a change of a choice led before, it may lead again, and then the
/// execution there can be computed by its trace.
class Passages {
 public:
  /// Those that a change of the choice led through, the last one first.
  const std::vector<const Passage*>& of(ChoiceNumber choice);
  /// Notes that a change of the choice, in the kernel `here`, led to a structure whose kernel is `there`.
  /// Does nothing where the same address has choices of different types, of which the one says nothing about
  /// the other.
  void add(const Kernel& here, ChoiceNumber choice, TracedStructure* to, const Kernel& there);
  /// The passage to a structure whose kernel is `there`, or null where the same address has choices of
  /// different types.
  Passage* between(const Kernel& here, TracedStructure* to, const Kernel& there);
  /// Lets a passage of these draw the block.
  void let_draw_block(Passage* passage);
  /// Those that draw the block.
  const std::vector<const Passage*>& drawing() const { return drawing_; }
  /// The passage was taken again.
  void repeat(ChoiceNumber choice, const Passage* taken);
  void forget(const TracedStructure* to);

 private:
  std::map<const TracedStructure*, Passage> by_end_;
  std::vector<const Passage*> drawing_;
  std::vector<std::vector<const Passage*>> by_choice_;
};

}  // namespace solitaire
