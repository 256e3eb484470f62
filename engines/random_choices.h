#pragma once
#include "base/random.h"
#include "solitaire/run/choices.h"

namespace solitaire {

/// Answers every choice at random, each value of its domain alike.
class RandomChoices : public Choices {
 public:
  explicit RandomChoices(RandomStream stream) : stream_(stream) {}

  std::optional<std::int64_t> answer(AddressId, const ChoiceDomain& domain) override {
    const auto values = static_cast<std::uint64_t>((domain.hi - domain.lo) / domain.step) + 1;
    return domain.lo + static_cast<std::int64_t>(stream_.below(values)) * domain.step;
  }

 private:
  RandomStream stream_;
};

}  // namespace solitaire
