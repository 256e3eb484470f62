#pragma once
#include <unordered_map>

#include "engines/sample/sampled_state.h"

namespace solitaire {

/// Answers as an execution that is the state of a chain.
class StateChoices : public Choices {
 public:
  explicit StateChoices(const SampledState& state) {
    for (const MetChoice& choice : state.choices) values_.emplace(choice.address, choice.value);
  }
  std::optional<TypedScalar> answer(AddressId address, const Distribution&) override {
    const auto found = values_.find(address);
    if (found == values_.end()) return std::nullopt;
    return found->second;
  }
  bool weighs() const override { return true; }

 private:
  std::unordered_map<AddressId, TypedScalar> values_;
};

}  // namespace solitaire
