#pragma once
#include <set>

#include "engines/solve/pins/pins.h"

namespace solitaire {

/// Leaves choices open as PinnedFloats does, and lets those at some addresses, or all, have any value around
/// their ranges: by several times what they span, and by no less than a reach.
class WideChoices : public PinnedFloats {
 public:
  /// `wide` are the addresses of the choices that are free; null means all. The reach is at most
  /// tuning::kMostReach.
  WideChoices(const std::set<AddressId>* wide, std::int64_t reach, Pins& pins)
      : PinnedFloats(pins), wide_(wide), reach_(reach), pins_(pins) {}

  Distribution widened(AddressId address, const Distribution& domain) override;

 private:
  const std::set<AddressId>* wide_;
  std::int64_t reach_;
  Pins& pins_;
};

}  // namespace solitaire
