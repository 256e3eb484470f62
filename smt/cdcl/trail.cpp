#include "smt/cdcl/trail.h"

namespace solitaire {

void Trail::reserve(int variable) {
  const std::size_t size = static_cast<std::size_t>(variable) + 1;
  if (assigned_.size() >= size) return;
  if (variable > middle_) {
    const int more = std::max(variable, 2 * middle_) - middle_;
    values_.insert(values_.begin(), static_cast<std::size_t>(more), Truth::kOpen);
    values_.insert(values_.end(), static_cast<std::size_t>(more), Truth::kOpen);
    middle_ += more;
  }
  assigned_.resize(size);
}

int Trail::undo() {
  const std::size_t start = levels_.back();
  const int decision = literals_[start];
  for (std::size_t i = start; i < literals_.size(); ++i) {
    set(literals_[i], Truth::kOpen);
    set(-literals_[i], Truth::kOpen);
  }
  literals_.resize(start);
  levels_.pop_back();
  kept_ = std::min(kept_, start);
  looked_at_ = start;
  return decision;
}

}  // namespace solitaire
