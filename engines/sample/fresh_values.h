#pragma once
#include <cstdint>
#include <vector>

#include "tracegraph/address.h"
#include "tracegraph/distribution.h"

namespace solitaire {

/// The values that a proposal draws for choices which the present execution does not have.
///
/// A proposal may be tried on several known paths before the program is run. What was drawn on the way to
/// where a path was found to be another one is kept for the next try: the proposed execution meets the same
/// choice, with the same distribution. To draw it again would favour paths that were tried first.
class FreshValues {
 public:
  explicit FreshValues(RandomStream& stream) : stream_(stream) {}

  /// The same at the same address until clear().
  TypedScalar draw(AddressId address, const Distribution& distribution) {
    if (address.index >= drawn_.size()) drawn_.resize(address.index + 1);
    Drawn& drawn = drawn_[address.index];
    if (drawn.proposal != proposal_ || drawn.value.type() != distribution.type())
      drawn = {proposal_, distribution.sample(stream_)};
    return drawn.value;
  }
  /// To be called where a proposal ends.
  void clear() { ++proposal_; }

 private:
  struct Drawn {
    std::uint64_t proposal = 0;
    TypedScalar value;
  };

  RandomStream& stream_;
  std::vector<Drawn> drawn_;  // by address number
  std::uint64_t proposal_ = 1;
};

}  // namespace solitaire
