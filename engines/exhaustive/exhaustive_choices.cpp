#include "engines/exhaustive/exhaustive_choices.h"

namespace solitaire {

std::optional<TypedScalar> ExhaustiveChoices::answer(AddressId address, const Distribution& domain) {
  if (!domain.is_finite()) return std::nullopt;
  // Equal answers lead to the same next choice, so the digits read so far belong to this execution, too.
  if (depth_ == digits_.size()) {
    const Distribution possible = widened(address, domain);
    digits_.push_back({possible.lo, possible.hi, possible.step});
  }
  return domain.typed(digits_[depth_++].value);
}

bool ExhaustiveChoices::advance() {
  depth_ = 0;
  if (!started_) return started_ = true;
  while (!digits_.empty()) {
    Digit& last = digits_.back();
    if (last.value + last.step <= last.hi) {
      last.value += last.step;
      return true;
    }
    digits_.pop_back();
  }
  return false;
}

}  // namespace solitaire
