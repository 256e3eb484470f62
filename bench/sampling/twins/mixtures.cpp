// Four objects, of each of which ten draws of four colours were seen: of three kinds, or of any number.
#include "bench/sampling/twins/restaurant.h"

namespace twins {
namespace {

constexpr std::size_t kObjects = 4, kDraws = 10, kColours = 4, kKinds = 3;
constexpr char kSeen[kObjects][kDraws + 1] = {"0100101102", "0011010130", "2332232330", "2232133233"};

std::size_t seen(std::size_t object, std::size_t draw) {
  return static_cast<std::size_t>(kSeen[object][draw] - '0');
}
double draws_given(std::size_t object, const SimplexWeights<kColours>& kind) {
  double sum = 0;
  for (std::size_t i = 0; i < kDraws; ++i) sum += kind.log_share(seen(object, i));
  return sum;
}
/// Walks on the logarithm of one weight. Returns the logarithm of the ratio of the ways.
template <std::size_t n>
double move(SimplexWeights<n>& weights, RandomStream& stream) {
  const double walk = 0.6 * draw_normal(stream);
  weights.weights[stream.below(n)] *= std::exp(walk);
  return walk;
}

struct Mixture {
  explicit Mixture(RandomStream&) {}
  double object(std::size_t i) const { return mix.log_share(kind[i]) + draws_given(i, kinds[kind[i]]); }
  double score() const {
    double sum = mix.log_prior();
    for (const auto& each : kinds) sum += each.log_prior();
    for (std::size_t i = 0; i < kObjects; ++i) sum += object(i);
    return sum;
  }
  double shown() const { return kind[0] == kind[1] ? 1 : 0; }

  SimplexWeights<kKinds> mix;
  std::array<SimplexWeights<kColours>, kKinds> kinds;
  std::array<std::size_t, kObjects> kind{};
};

/// As many steps go to each kind of unknown as there are of it.
constexpr std::uint64_t kOfMix = kKinds, kOfKinds = kKinds * kColours;

struct MixtureRescoring : Mixture {
  explicit MixtureRescoring(RandomStream& stream) : Mixture(stream), present(score()) {}
  void step(RandomStream& stream) {
    const std::uint64_t which = stream.below(kOfMix + kOfKinds + kObjects);
    const Mixture before = *this;
    double ways = 0;
    if (which < kOfMix) {
      ways = move(mix, stream);
    } else if (which < kOfMix + kOfKinds) {
      ways = move(kinds[(which - kOfMix) / kColours], stream);
    } else {
      kind[which - kOfMix - kOfKinds] = stream.below(kKinds);
    }
    const double proposed = score();
    if (accepts(proposed - present + ways, stream)) {
      present = proposed;
    } else {
      static_cast<Mixture&>(*this) = before;
    }
  }
  double present;
};

struct MixtureIncremental : Mixture {
  using Mixture::Mixture;
  double mix_score() const {
    double sum = mix.log_prior();
    for (const std::size_t each : kind) sum += mix.log_share(each);
    return sum;
  }
  double kind_score(std::size_t k) const {
    double sum = kinds[k].log_prior();
    for (std::size_t i = 0; i < kObjects; ++i)
      if (kind[i] == k) sum += draws_given(i, kinds[k]);
    return sum;
  }
  template <std::size_t n, class Score>
  void walk(SimplexWeights<n>& weights, Score score, RandomStream& stream) {
    const SimplexWeights<n> before = weights;
    const double present = score();
    const double ways = move(weights, stream);
    if (!accepts(score() - present + ways, stream)) weights = before;
  }
  void step(RandomStream& stream) {
    const std::uint64_t which = stream.below(kOfMix + kOfKinds + kObjects);
    if (which < kOfMix)
      return walk(
          mix, [&] { return mix_score(); }, stream);
    if (which < kOfMix + kOfKinds) {
      const std::size_t k = (which - kOfMix) / kColours;
      return walk(
          kinds[k], [&] { return kind_score(k); }, stream);
    }
    const std::size_t i = which - kOfMix - kOfKinds, before = kind[i];
    const double present = object(i);
    kind[i] = stream.below(kKinds);
    if (!accepts(object(i) - present, stream)) kind[i] = before;
  }
};

struct InfiniteMixture {
  explicit InfiniteMixture(RandomStream&) : seats(kObjects) {}
  double objects_from(std::size_t first) const {
    double sum = 0;
    for (std::size_t i = first; i < kObjects; ++i) sum += draws_given(i, kinds[seats.seat(i)]);
    return sum;
  }
  double score() const {
    double sum = objects_from(0);
    for (const auto& each : kinds) sum += each.log_prior();
    return sum;
  }
  double shown() const { return seats.seat(0) == seats.seat(1) ? 1 : 0; }

  Restaurant seats;
  std::array<SimplexWeights<kColours>, kObjects> kinds;
};

constexpr std::uint64_t kOfObjects = kObjects * kColours;

struct InfiniteMixtureRescoring : InfiniteMixture {
  explicit InfiniteMixtureRescoring(RandomStream& stream) : InfiniteMixture(stream), present(score()) {}
  void step(RandomStream& stream) {
    const std::uint64_t which = stream.below(kOfObjects + kObjects);
    if (which < kOfObjects) {
      SimplexWeights<kColours>& kind = kinds[which / kColours];
      const SimplexWeights<kColours> before = kind;
      const double ways = move(kind, stream);
      return take(ways, stream, [&] { kind = before; });
    }
    const std::size_t i = which - kOfObjects, before = seats.link(i);
    seats.link(i, stream.below(i + 1));
    take(0, stream, [&] { seats.link(i, before); });
  }
  template <class Undo>
  void take(double ways, RandomStream& stream, Undo undo) {
    const double proposed = score();
    if (accepts(proposed - present + ways, stream)) {
      present = proposed;
    } else {
      undo();
    }
  }
  double present;
};

struct InfiniteMixtureIncremental : InfiniteMixture {
  using InfiniteMixture::InfiniteMixture;
  double kind_score(std::size_t k) const {
    double sum = kinds[k].log_prior();
    for (std::size_t i = k; i < kObjects; ++i)
      if (seats.seat(i) == k) sum += draws_given(i, kinds[k]);
    return sum;
  }
  void step(RandomStream& stream) {
    const std::uint64_t which = stream.below(kOfObjects + kObjects);
    if (which < kOfObjects) {
      const std::size_t k = which / kColours;
      const SimplexWeights<kColours> before = kinds[k];
      const double present = kind_score(k);
      const double ways = move(kinds[k], stream);
      if (!accepts(kind_score(k) - present + ways, stream)) kinds[k] = before;
      return;
    }
    const std::size_t i = which - kOfObjects, before = seats.link(i);
    const double present = objects_from(i);
    seats.link(i, stream.below(i + 1));
    if (!accepts(objects_from(i) - present, stream)) seats.link(i, before);
  }
};

}  // namespace

void measure_mixtures(const Measurement& measure, std::uint64_t seed) {
  measure.operator()<MixtureIncremental>("mixture incremental", seed);
  measure.operator()<MixtureRescoring>("mixture rescoring", seed);
  measure.operator()<InfiniteMixtureIncremental>("infinite_mixture incremental", seed);
  measure.operator()<InfiniteMixtureRescoring>("infinite_mixture rescoring", seed);
}

}  // namespace twins
