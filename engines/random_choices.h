#pragma once
#include "base/random.h"
#include "solitaire/run/choices.h"

namespace solitaire {

/// Answers every choice with a value drawn from its distribution.
class RandomChoices : public Choices {
 public:
  explicit RandomChoices(RandomStream stream) : stream_(stream) {}

  std::optional<TypedScalar> answer(AddressId, const Distribution& domain) override {
    return domain.sample(stream_);
  }

 private:
  RandomStream stream_;
};

}  // namespace solitaire
