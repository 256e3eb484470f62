#include "smt/cdcl/vmtf_queue.h"

#include <algorithm>

namespace solitaire {

void VmtfQueue::move_to_front(std::span<const int> variables) {
  if (variables.empty()) return;
  const auto last = static_cast<std::size_t>(*std::ranges::max_element(variables));
  if (links_.size() <= last) links_.resize(last + 1);
  moving_.clear();
  for (const int variable : variables) moving_.push_back({link(variable).moved, moving_.size(), variable});
  std::ranges::sort(moving_);
  for (const auto& [moved, place, variable] : moving_) {
    if (moved != 0) take_out(variable);
    put_first(variable);
  }
}

void VmtfQueue::take_out(int variable) {
  const auto [ahead, behind, moved] = link(variable);
  if (next_ == variable) next_ = behind;
  (ahead != 0 ? link(ahead).behind : front_) = behind;
  if (behind != 0) link(behind).ahead = ahead;
}

/// The variable at the front may be open, so the search for open ones begins there.
void VmtfQueue::put_first(int variable) {
  if (front_ != 0) link(front_).ahead = variable;
  link(variable) = {0, front_, ++moves_};
  front_ = next_ = variable;
}

void VmtfQueue::clear() {
  links_.clear();
  front_ = next_ = 0;
  moves_ = 0;
}

}  // namespace solitaire
