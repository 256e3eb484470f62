#include "engines/solve/pins/wide_choices.h"

#include <algorithm>

#include "engines/tuning.h"

namespace solitaire {

Distribution WideChoices::widened(AddressId address, const Distribution& domain) {
  if ((wide_ != nullptr && wide_->count(address) == 0) || domain.family != Distribution::Family::kRange)
    return domain;
  const std::int64_t span = std::min(domain.hi - domain.lo + 1, tuning::kMostReach);
  std::int64_t by =
      std::clamp(std::max(tuning::kReachInSpans * span, reach_), tuning::kLeastReach, tuning::kMostReach);
  for (const Pin* pin : pins_.at(address)) {
    const auto value = pin->value ? converted(*pin->value, Type::kInt) : std::nullopt;
    if (!value) continue;
    const std::int64_t distance = std::max(domain.lo - value->as_int(), value->as_int() - domain.hi);
    if (distance <= tuning::kMostReach) by = std::max(by, distance);
  }
  return Distribution::range(domain.lo - by, domain.hi + by);
}

}  // namespace solitaire
