#pragma once
#include <vector>

#include "solitaire/run/choices.h"

namespace solitaire {

/// Answers the choices of one execution after the other with every combination of values, the last choice
/// counting fastest; from lower to higher, within what a choice can be at most.
class ExhaustiveChoices : public Choices {
 public:
  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override;
  /// Goes to the next execution; false if there is none.
  bool advance();

 private:
  struct Digit {
    std::int64_t value, hi, step;
  };
  std::vector<Digit> digits_;
  std::size_t depth_ = 0;
  bool started_ = false;
};

}  // namespace solitaire
