#pragma once
#include <set>

#include "engines/solve/pins.h"

namespace solitaire {

/// Leaves choices open, and those at some addresses, or all, free to have any value around their ranges: by
/// several times what they span, and by no less than a reach.
class WideChoices : public Choices {
 public:
  /// A reach that is not much.
  static constexpr std::int64_t kLeast = 64;
  /// Products of what lies further out would grow past 62 bits.
  static constexpr std::int64_t kMost = std::int64_t{1} << 28;

  /// `wide` null: all.
  WideChoices(const std::set<AddressId>* wide, std::int64_t reach, Pins& pins)
      : wide_(wide), reach_(reach), pins_(pins) {}

  std::optional<TypedScalar> answer(AddressId, const Distribution&) override { return std::nullopt; }
  Distribution widened(AddressId address, const Distribution& domain) override;

 private:
  const std::set<AddressId>* wide_;
  std::int64_t reach_;
  Pins& pins_;
};

}  // namespace solitaire
