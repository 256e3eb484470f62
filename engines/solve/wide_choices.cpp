#include "engines/solve/wide_choices.h"

#include <algorithm>

namespace solitaire {

Distribution WideChoices::widened(AddressId address, const Distribution& domain) {
  constexpr std::int64_t kSpans = 4;
  if ((wide_ != nullptr && wide_->count(address) == 0) || domain.family != Distribution::Family::kRange)
    return domain;
  const std::int64_t span = std::min(domain.hi - domain.lo + 1, kMost);
  std::int64_t by = std::clamp(std::max(kSpans * span, reach_), kLeast, kMost);
  for (const Pin* pin : pins_.at(address)) {
    const std::int64_t distance = std::max(domain.lo - pin->value, pin->value - domain.hi);
    if (distance <= kMost) by = std::max(by, distance);
  }
  return {domain.lo - by, domain.hi + by, 1, domain.family};
}

}  // namespace solitaire
