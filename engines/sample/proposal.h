#pragma once
#include <vector>

#include "base/random.h"
#include "engines/sample/move.h"
#include "tracegraph/address.h"
#include "tracegraph/distribution.h"

namespace solitaire {

/// A value that a choice might change to.
struct Proposal {
  TypedScalar value;
  /// log q(old | new) - log q(new | old), where q is the density with which the one proposes the other.
  double log_ratio = 0;
  Move move = Move::kPrior;
};

/// Proposes values for single choices, by what their distributions alone say.
class Proposer {
 public:
  explicit Proposer(RandomStream& stream) : stream_(stream) {}

  Proposal propose(AddressId address, const Distribution& distribution, TypedScalar value);
  /// A value that does not depend on the present one, or all others alike.
  Proposal anywhere(const Distribution& distribution, TypedScalar value);
  /// Tunes the walk of that choice towards an acceptance of 0.44, which is best for walks in one dimension
  /// (Gelman, Roberts and Gilks 1996), by the method of Robbins and Monro. To be told during warm-up only.
  void learn(AddressId address, double acceptance);

 private:
  struct Scale {
    double factor = 1;  // on the usual step
    double log_factor = 0;
    double told = 0;
  };
  Scale& scale(AddressId address);
  Proposal from_prior(const Distribution& distribution, TypedScalar value);
  Proposal other(const Distribution& distribution, TypedScalar value);
  std::uint64_t any_of(std::uint64_t count);
  Proposal neighbour(const Distribution& distribution, TypedScalar value);
  Proposal walk(double scale, const Distribution& distribution, TypedScalar value);

  RandomStream& stream_;
  std::vector<Scale> scales_;  // by the numbers of the addresses
};

}  // namespace solitaire
