#pragma once
#include <cstddef>
#include <vector>

namespace solitaire {

/// Does work on a part of a graph and on all parts that it needs, those first, each once. It keeps a stack of
/// its own, as graphs can be deeper than the machine's stack.
///
/// `is_done(part)` returns true once the work on a part is done, `push_needed(part, pending)` appends the
/// parts that it needs and that are not done, and `finish(part)` does the work.
template <class Part, class IsDone, class PushNeeded, class Finish>
void in_post_order(Part root, IsDone is_done, PushNeeded push_needed, Finish finish) {
  std::vector<Part> pending{root};
  while (!pending.empty()) {
    const Part at = pending.back();
    const std::size_t waiting = pending.size();
    if (!is_done(at)) {
      push_needed(at, pending);
      if (pending.size() > waiting) continue;
      finish(at);
    }
    pending.pop_back();
  }
}

}  // namespace solitaire
